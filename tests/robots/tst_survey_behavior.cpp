#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/descriptions.h"
#include "tests/doubles/toy_airrobot.h"
#include "tests/suite/suite.h"

namespace tst_survey_behavior {

using namespace usar;
using namespace usar::agent;
using namespace usar::test;

namespace {

/// Who decides: every test runs with each of them.
std::string decider = "airrobot/cpp";

const Task field_task{"R1", Pose{}, {Vec2(5, 5), Vec2(45, 35)}};

ParameterSet parameters(const std::map<std::string, ParameterValue>& values) {
    return ParameterSet::make(airrobot::AirRobot().description().behaviors[0].parameters, values).value();
}

ToyFlight flight(const ToyWorld& world, const Task& task = field_task,
                 const std::map<std::string, ParameterValue>& values = {}, ToyFaults faults = {},
                 Seconds battery = Seconds(1e5), std::optional<Pose> standing_in_map = {}) {
    auto behavior = airrobot::AirRobot().createBehavior(decider, {task, parameters(values)});
    Q_ASSERT(behavior);
    return {ToyAirRobot(world, standing_in_map.value_or(task.start_in_map), faults, battery), std::move(*behavior)};
}

ToyWorld hills() {
    ToyWorld world;
    world.ground_m = [](const Vec2& at_m) { return 4.0 * std::sin(at_m.x() / 12.0) * std::cos(at_m.y() / 10.0); };
    return world;
}

ToyWorld wood(std::uint64_t seed) {
    ToyWorld world = hills();
    Random random = seeded(seed, 1);
    for (int tries = 0; tries < 300; ++tries) {
        ToyTree tree;
        tree.at_m = {uniform(random, 0.0, 50.0), uniform(random, 0.0, 40.0)};
        tree.trunk_top_m = world.ground_m(tree.at_m) + uniform(random, 3.0, 9.0);
        tree.crown_radius_m = uniform(random, 1.0, 2.5);
        const bool apart = std::ranges::all_of(
            world.trees, [&](const ToyTree& other) { return (other.at_m - tree.at_m).norm() > 6.0; });
        if (apart && tree.at_m.norm() > 8.0)
            world.trees.push_back(tree);
    }
    return world;
}

/// Until some time after it entered the state.
void runInto(ToyFlight& toy, const QString& state, Seconds then) {
    while (!toy.finished() && toy.status().state != state.toStdString())
        toy.tick();
    toy.run(then);
}

bool contains(const std::vector<std::string>& texts, const std::string& part) {
    return std::ranges::any_of(texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

} // namespace

class tst_SurveyBehavior : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data() {
        QTest::addColumn<QByteArray>("behavior");
        QTest::newRow("state machine") << QByteArray("airrobot/cpp");
        QTest::newRow("POSH plan") << QByteArray("airrobot/posh");
    }
    void init() {
        QFETCH_GLOBAL(QByteArray, behavior);
        decider = behavior.toStdString();
    }

    void scansAFieldLaneByLaneAndLandsAtItsBase() {
        ToyFlight toy = flight({});
        toy.run(Seconds(1000));
        QVERIFY(toy.ending());
        QVERIFY2(toy.ending()->success, toy.ending()->reason.c_str());
        for (const char* state :
             {"waiting for Sonar geometry", "calibrating the INS on the ground", "taking off", "flying to lane 1 of 4",
              "scanning lane 1 of 4", "scanning lane 4 of 4", "returning to base", "landing"})
            QVERIFY2(contains(toy.states(), state), state);
        QVERIFY(toy.robot().onGround());
        QVERIFY(toy.robot().position_m().head<2>().norm() < 2.0);
        QCOMPARE(*toy.status().progress_pct, 100.0);
        QCOMPARE(toy.robot().collisions(), 0);
        QVERIFY(toy.marks(MarkKind::Path).size() > 150);
        QCOMPARE(toy.marks(MarkKind::Landing).size(), std::size_t(1));
        QVERIFY(toy.events().size() <= 4); // The outlook and the INS are told, and nothing else.
    }

    void commandsNothingThatTheRobotCannotDo() {
        ToyFlight toy = flight({}, field_task, {{"transit_speed_m_s", 2.0}, {"climb_speed_m_s", 2.0}}, {.slow = true});
        toy.run(Seconds(300));
        for (const CausedCommand& caused : toy.commands())
            if (const auto* drive = std::get_if<protocol::AerialDrive>(&caused.command))
                QVERIFY(std::hypot(*drive->forward_m_s, *drive->left_m_s) < 0.71 && *drive->climb_m_s < 0.61);
    }

    void landsWhereItStoodWhenItsStartPoseWasTaken() {
        const Pose beside_in_map{{0.0, 4.0, 0.0}, 0.0, 0.0, 0.0};
        ToyFlight toy = flight({}, field_task, {}, {}, Seconds(1e5), beside_in_map);
        toy.run(Seconds(1000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY((toy.robot().position_m() - beside_in_map.position_m).head<2>().norm() < 1.5);
    }

    // It sets off to the side for half a second once it is 2 m up, to look up.
    void takesOffStraightUpBeforeAnythingElse() {
        ToyFlight toy = flight({});
        while (toy.robot().position_m().z() < 5.0) {
            toy.tick();
            QVERIFY(toy.robot().position_m().head<2>().norm() < (toy.robot().position_m().z() < 2.0 ? 0.3 : 1.6));
        }
        QVERIFY(toy.robot().position_m().head<2>().norm() < 0.5);
    }

    void saysThatItDoesNotLeaveTheGround() {
        ToyFlight toy = flight({}, field_task, {}, {.lid_z_m = 0.3});
        toy.run(Seconds(300));
        QVERIFY(toy.ending() && !toy.ending()->success);
        QVERIFY2(contains({toy.ending()->reason}, "does not leave the ground"), toy.ending()->reason.c_str());
        QVERIFY(!contains(toy.events(), "ceiling"));
    }

    void fliesBelowWhatItMeets() {
        ToyFlight toy = flight({}, field_task, {}, {.lid_z_m = 4.0});
        runInto(toy, "scanning lane 1 of 4", Seconds(5));
        QVERIFY(contains(toy.events(), "A ceiling was touched 4.0 m above the base"));
        QVERIFY2(toy.robot().position_m().z() < 3.5, qPrintable(QString::number(toy.robot().position_m().z())));
        toy.run(Seconds(1500));
        QVERIFY(toy.ending() && toy.ending()->success);
        QCOMPARE(std::ranges::count_if(toy.events(), [](const auto& text) { return contains({text}, "ceiling"); }), 1);
    }

    void fliesWholeAreaAtScanAltitudeOverHills() {
        const ToyWorld world = hills();
        ToyFlight toy = flight(world);
        toy.run(Seconds(1500));
        QVERIFY(toy.ending() && toy.ending()->success);
        int scanning = 0;
        int right = 0;
        for (const Vec3& at_m : toy.path_m()) {
            const double height_m = at_m.z() - world.ground_m(at_m.head<2>());
            if (!field_task.area_in_map.contains(at_m.head<2>()))
                continue;
            ++scanning;
            right += height_m > 4.0 && height_m < 9.5 ? 1 : 0;
        }
        QVERIFY2(right > 0.95 * scanning, qPrintable(QString("%1 of %2").arg(right).arg(scanning)));
    }

    void surveysAWoodWithoutTouchingIt_data() {
        QTest::addColumn<int>("seed");
        for (const int seed : {3, 4, 5})
            QTest::newRow(qPrintable(QString("wood %1").arg(seed))) << seed;
    }
    void surveysAWoodWithoutTouchingIt() {
        QFETCH(int, seed);
        ToyFlight toy = flight(wood(static_cast<std::uint64_t>(seed)), field_task, {}, {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending());
        QVERIFY2(toy.ending()->success, toy.ending()->reason.c_str());
        QCOMPARE(toy.robot().collisions(), 0);
        QVERIFY(toy.marks(MarkKind::LowRisk).size() + toy.marks(MarkKind::HighRisk).size() > 0);
    }

    void doesNotClimbBesideATrunkIntoItsCrown_data() {
        QTest::addColumn<double>("aside_m");
        for (const double aside_m : {1.6, 2.0, 2.4})
            QTest::newRow(qPrintable(QString("%1 m beside the lane").arg(aside_m))) << aside_m;
    }
    void doesNotClimbBesideATrunkIntoItsCrown() {
        QFETCH(double, aside_m);
        ToyWorld world; // a slope under the lane calls for a climb just where a wide crown hangs over it
        world.ground_m = [](const Vec2& at_m) { return std::clamp((at_m.x() - 15.0) * 0.4, 0.0, 8.0); };
        world.trees.push_back({Vec2(22, 10 + aside_m), 0.25, 13.0, 2.5});
        const Task one_lane{"R1", Pose{}, {Vec2(2, 6), Vec2(42, 14)}};
        ToyFlight toy = flight(world, one_lane);
        toy.run(Seconds(1000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QCOMPARE(toy.robot().collisions(), 0);
        QVERIFY(toy.robot().lowestClearance_m() > 0.0);
    }

    void chargesInTimeAndResumesWhereItStopped() {
        ToyFlight toy = flight({}, field_task, {{"battery_range_m", 150.0}}, {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(toy.status().charges >= 1);
        QCOMPARE(toy.marks(MarkKind::Recharge).size(), std::size_t(toy.status().charges));
        QVERIFY(contains(toy.states(), "charging"));
        QVERIFY(contains(toy.events(), "INS was set from ground truth"));
        for (const Published& value : toy.published())
            if (const auto* status = std::get_if<BehaviorStatus>(&value))
                QVERIFY(*status->battery_used_pct < 100.0); // home before it is empty
    }

    /// In a hurry, it flies home between its sorties, with lanes that end near its base; otherwise it breaks off lanes.
    void chargesBetweenItsSorties() {
        const std::map<std::string, ParameterValue> values{
            {"transit_speed_m_s", 2.0}, {"scan_speed_m_s", 2.0}, {"battery_range_m", 260.0}};
        ToyFlight toy = flight({}, field_task, values, {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(contains(toy.events(), "A sortie is done; home to charge."));
        QVERIFY(toy.status().charges >= 1);
        QCOMPARE(toy.marks(MarkKind::Recharge).size(), std::size_t(0));
        QCOMPARE(*toy.status().progress_pct, 100.0);
    }

    /// The battery lasts for less than it was planned for, so lanes are broken off, and the rest is planned anew.
    void plansAnewAfterALandingThatWasNotPlanned() {
        ToyFlight toy =
            flight({}, field_task, {{"transit_speed_m_s", 2.0}, {"scan_speed_m_s", 2.0}}, {.ins_drifts = true});
        runInto(toy, "scanning lane 2 of 4", Seconds(5));
        toy.set(parameters({{"transit_speed_m_s", 2.0}, {"scan_speed_m_s", 2.0}, {"battery_range_m", 140.0}}));
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(toy.marks(MarkKind::Recharge).size() >= 1);
        QVERIFY(contains(toy.events(), "What is left is planned anew: "));
        QVERIFY(contains(toy.states(), " of 5")); // What was flown of the second one is a lane, too.
        QCOMPARE(*toy.status().progress_pct, 100.0);
        for (const Published& value : toy.published())
            if (const auto* status = std::get_if<BehaviorStatus>(&value))
                QVERIFY(!status->progress_pct || *status->progress_pct <= 100.0);
    }

    /// The robot breaks off a lane past hidden ground for a charge, and then chooses the rest by what it has seen.
    void choosesAddedLanesAnewAfterALanding() {
        std::map<std::string, ParameterValue> values{
            {"transit_speed_m_s", 2.0}, {"scan_speed_m_s", 2.0}, {"lane_spacing_m", 15.0}, {"least_gain_m", 0.2}};
        ToyFlight toy = flight(wood(3), field_task, values, {.ins_drifts = true});
        for (int tick = 0; tick < 5000 && !contains(toy.events(), "More lanes show ground"); ++tick)
            toy.tick();
        const std::size_t added_at = toy.events().size();
        QVERIFY(contains(toy.events(), "More lanes show ground"));
        values["battery_range_m"] = 210.0;
        toy.set(parameters(values));
        toy.run(Seconds(5000));
        QVERIFY(toy.ending());
        QVERIFY2(toy.ending()->success, toy.ending()->reason.c_str());
        QVERIFY(toy.status().charges >= 1);
        const std::vector<std::string> events = toy.events();
        QVERIFY(contains({events.begin() + static_cast<std::ptrdiff_t>(added_at), events.end()},
                         "What is left is planned anew: "));
        QCOMPARE(*toy.status().progress_pct, 100.0);
        QVERIFY(toy.robot().onGround());
    }

    /// Else nobody would know how far it drifted in its last flight, which may be its only one.
    void setsTheInsAfterItsLastLanding() {
        ToyFlight toy = flight({}, field_task, {}, {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QCOMPARE(toy.status().charges, 0);
        QCOMPARE(std::ranges::count(toy.events(), "The INS was set from ground truth."), 2);
        const auto landing = std::ranges::find(toy.states(), "landing");
        QVERIFY(landing != toy.states().end());
        QVERIFY(std::find(landing, toy.states().end(), "calibrating the INS on the ground") != toy.states().end());
        QVERIFY(std::find(landing, toy.states().end(), "charging") == toy.states().end());
    }
    void aSurveyThatIsDoneStaysDoneWhenAskedToLand() {
        ToyFlight toy = flight({}, field_task);
        runInto(toy, "landing", Seconds(0));
        runInto(toy, "calibrating the INS on the ground", Seconds(1));
        toy.order(Order::LandNow);
        toy.run(Seconds(1));
        QVERIFY(toy.ending() && toy.ending()->success);
    }

    void goesHomeForGoodWhenTheNextPlaceIsOutOfRange() {
        const Task far{"R1", Pose{}, {Vec2(200, 0), Vec2(230, 20)}};
        ToyFlight toy = flight({}, far, {{"battery_range_m", 300.0}, {"recharge_time_s", 0.0}});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending());
        QVERIFY(!toy.ending()->success);
        QVERIFY2(toy.ending()->reason.find("range") != std::string::npos, toy.ending()->reason.c_str());
        QVERIFY(toy.robot().onGround());
    }

    void landsBeforeTheRobotsOwnBatteryIsEmpty() {
        ToyFlight toy = flight({}, field_task, {}, {}, Seconds(200.0));
        toy.run(Seconds(250));
        QVERIFY(toy.ending());
        QVERIFY(!toy.ending()->success);
        QVERIFY(toy.robot().onGround());
        QVERIFY(toy.robot().now() < Seconds(100.0 + 200.0));
    }

    void resetsTheInsAfterEachQuadrant() {
        ToyFlight toy = flight({}, field_task, {{"quadrant_limit_m", 30.0}}, {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(toy.status().charges >= 1);
        QVERIFY(contains(toy.events(), "quadrant"));
    }

    /// In a hurry it does not charge a battery that it has hardly used.
    void fliesOnAfterASmallPartInAHurry_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("range_m");
        QTest::addColumn<bool>("goes_home");
        QTest::newRow("in no hurry") << 1.6 << 1000.0 << true;
        QTest::newRow("in a hurry") << 2.0 << 1000.0 << false;
        QTest::newRow("in a hurry, with a battery half empty") << 2.0 << 200.0 << true;
    }
    void fliesOnAfterASmallPartInAHurry() {
        QFETCH(double, transit_m_s);
        QFETCH(double, range_m);
        QFETCH(bool, goes_home);
        ToyFlight toy =
            flight({}, field_task,
                   {{"quadrant_limit_m", 30.0}, {"transit_speed_m_s", transit_m_s}, {"battery_range_m", range_m}},
                   {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QCOMPARE(contains(toy.events(), "is done; home"), goes_home);
    }

    void fliesOnAfterAQuadrantWhereNoInsNeedsToBeSet() {
        ToyFlight toy = flight({}, field_task, {{"quadrant_limit_m", 30.0}, {"navigate_by_truth", true}});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QCOMPARE(toy.status().charges, 0);
        QVERIFY(!contains(toy.states(), "returning to charge"));
        QCOMPARE(std::ranges::count(toy.states(), "returning to base"), 1);
    }

    void neverSinksBelowItsFloorButToLand() {
        ToyWorld ravine;
        ravine.ground_m = [](const Vec2& at_m) { return std::abs(at_m.x() - 25.0) < 8.0 ? -12.0 : 0.0; };
        ToyFlight toy = flight(ravine, field_task, {{"floor_level_m", 3.0}});
        toy.run(Seconds(2000));
        QVERIFY(toy.ending() && toy.ending()->success);
        for (const Vec3& at_m : toy.path_m())
            if (field_task.area_in_map.contains(at_m.head<2>()))
                QVERIFY(at_m.z() > 2.5);
    }

    /// Its INS drifts, and it neither notices nor sets it.
    void navigatesByGroundTruthWhereAPersonWantsIt() {
        ToyFlight toy =
            flight({}, field_task, {{"navigate_by_truth", true}, {"battery_range_m", 150.0}}, {.ins_drifts = true});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(toy.ending()->reason.find("by ground truth") != std::string::npos);
        QVERIFY(contains(toy.events(), "navigates by ground truth"));
        QVERIFY(!contains(toy.events(), "INS was set"));
        QVERIFY(toy.status().charges >= 1);
        QVERIFY(toy.robot().position_m().head<2>().norm() < 0.6);
    }

    void choosesItsFloorWhereNobodySetsOne_data() {
        QTest::addColumn<bool>("dry");
        QTest::addColumn<QString>("words");
        QTest::newRow("nobody knows the water") << false << "above its start";
        QTest::newRow("the world is dry from -12 m on") << true << "water does not exceed";
    }
    void choosesItsFloorWhereNobodySetsOne() {
        QFETCH(bool, dry);
        QFETCH(QString, words);
        ToyWorld valley;
        valley.ground_m = [](const Vec2& at_m) { return -10.0 * std::clamp((at_m.x() - 5.0) / 15.0, 0.0, 1.0); };
        Task task = field_task;
        if (dry)
            task.dry_above_m = -12.0;
        ToyFlight toy = flight(valley, task);
        toy.run(Seconds(2000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(contains(toy.events(), words.toStdString()));
        double lowest_m = 100.0;
        for (const Vec3& at_m : toy.path_m())
            if (field_task.area_in_map.contains(at_m.head<2>()))
                lowest_m = std::min(lowest_m, at_m.z());
        QVERIFY2(dry ? lowest_m < 0.0 : lowest_m > 2.0, qPrintable(QString::number(lowest_m)));
    }

    void givesUpAGoalThatCannotBeReached_data() {
        QTest::addColumn<double>("most_left_out_pct");
        QTest::addColumn<bool>("success");
        QTest::addColumn<QString>("reason");
        QTest::newRow("more than may be left out") << 10.0 << false << "100 % of the lanes, and at most 10 % may be";
        QTest::newRow("everything may be left out") << 100.0 << true << "goals left out: 1, 100 % of the lanes.";
    }
    void givesUpAGoalThatCannotBeReached() {
        QFETCH(double, most_left_out_pct);
        QFETCH(bool, success);
        QFETCH(QString, reason);
        ToyWorld world; // a ring of trees too tall to climb over, around a point of the second lane
        for (int i = 0; i < 40; ++i)
            world.trees.push_back(
                {Vec2(25, 20) + 7.0 * Vec2(std::cos(i * pi / 20), std::sin(i * pi / 20)), 0.6, 80.0, 0.0});
        const Task task{"R1", Pose{}, {Vec2(24, 19), Vec2(26, 21)}};
        ToyFlight toy =
            flight(world, task,
                   {{"give_up_after_s", 40.0}, {"goal_distance_m", 50.0}, {"most_left_out_pct", most_left_out_pct}});
        toy.run(Seconds(3000));
        QVERIFY(toy.ending());
        QVERIFY(!toy.marks(MarkKind::GoalGivenUp).empty());
        QCOMPARE(toy.ending()->success, success);
        QVERIFY2(QString::fromStdString(toy.ending()->reason).contains(reason), toy.ending()->reason.c_str());
        QCOMPARE(toy.robot().collisions(), 0);
    }

    void hoversWhilePausedAndGoesOn() {
        ToyFlight toy = flight({});
        toy.run(Seconds(60));
        toy.order(Order::Pause);
        toy.run(Seconds(5));
        const Vec3 held_m = toy.robot().position_m();
        toy.run(Seconds(60));
        QVERIFY((toy.robot().position_m() - held_m).norm() < 1.0);
        QVERIFY(toy.status().state.starts_with("paused"));
        toy.order(Order::Resume);
        toy.run(Seconds(1000));
        QVERIFY(toy.ending() && toy.ending()->success);
    }

    void aLongPauseCostsNoGoal_data() {
        QTest::addColumn<QString>("state");
        for (const char* state : {"taking off", "flying to lane 1 of 4", "scanning lane 1 of 4", "returning to base"})
            QTest::newRow(state) << state;
    }
    void aLongPauseCostsNoGoal() {
        QFETCH(QString, state);
        ToyFlight toy = flight({});
        runInto(toy, state, Seconds(2));
        toy.order(Order::Pause);
        toy.run(Seconds(120));
        QCOMPARE(toy.status().state, "paused, " + state.toStdString());
        toy.order(Order::Resume);
        toy.run(Seconds(1000));
        QVERIFY(toy.ending());
        QVERIFY2(toy.ending()->success, toy.ending()->reason.c_str());
        QVERIFY(toy.marks(MarkKind::GoalGivenUp).empty());
    }

    void itsOwnBatteryEndsAPause_data() {
        QTest::addColumn<QString>("state");
        QTest::addColumn<double>("battery_s");
        QTest::newRow("while taking off") << "taking off" << 150.0;
        QTest::newRow("on a lane") << "scanning lane 1 of 4" << 200.0;
        QTest::newRow("on the way home") << "returning to base" << 330.0;
    }
    void itsOwnBatteryEndsAPause() {
        QFETCH(QString, state);
        QFETCH(double, battery_s);
        ToyFlight toy = flight({}, field_task, {}, {}, Seconds(battery_s));
        runInto(toy, state, Seconds(2));
        toy.order(Order::Pause);
        toy.run(Seconds(100.0 + battery_s) - toy.robot().now()); // the toy's clock starts at 100 s
        QVERIFY(contains(toy.events(), "pause ends"));
        QVERIFY(toy.ending());
        QVERIFY(toy.robot().onGround());
        QVERIFY(toy.robot().position_m().head<2>().norm() < 3.0);
    }

    void landsAtOnceWhenAsked_data() {
        QTest::addColumn<double>("after_s");
        QTest::newRow("before take-off") << 1.0;
        QTest::newRow("in flight") << 60.0;
    }
    void landsAtOnceWhenAsked() {
        QFETCH(double, after_s);
        ToyFlight toy = flight({});
        toy.run(Seconds(after_s));
        const Vec3 asked_at_m = toy.robot().position_m();
        toy.order(Order::LandNow);
        toy.run(Seconds(60));
        QVERIFY(toy.ending());
        QVERIFY(!toy.ending()->success);
        QVERIFY(toy.robot().onGround());
        QVERIFY((toy.robot().position_m() - asked_at_m).head<2>().norm() < 5.0);
    }

    /// Only the base and one place in the area are fit for a landing.
    void inNeedItLandsAtThePlaceThatItChose() {
        const Vec2 fit_m(25, 10);
        ToyWorld world;
        world.ground_m = [&](const Vec2& at_m) {
            const double off_m = std::min((at_m - fit_m).norm() - 2.0, at_m.norm() - 4.0);
            return std::clamp(off_m, 0.0, 1.0) * (0.5 + 0.5 * std::sin(2.0 * at_m.x()) * std::sin(2.0 * at_m.y()));
        };
        ToyFlight toy = flight(world);
        runInto(toy, "scanning lane 2 of 4", Seconds(12));
        QVERIFY((toy.robot().position_m().head<2>() - fit_m).norm() > 5.0);
        toy.order(Order::LandNow);
        toy.run(Seconds(120));
        QVERIFY(toy.ending() && !toy.ending()->success);
        QVERIFY2(toy.robot().onGround(), toy.ending()->reason.c_str());
        QVERIFY2((toy.robot().position_m().head<2>() - fit_m).norm() < 2.3, // So far, it is level to a few decimeters.
                 qPrintable(QString("%1 %2").arg(toy.robot().position_m().x()).arg(toy.robot().position_m().y())));
    }

    void waitsForASilentSensorThenAsksForAHand_data() {
        QTest::addColumn<bool>("sonars");
        QTest::addColumn<QString>("one_sonar");
        QTest::addColumn<QString>("named");
        QTest::newRow("sonars") << true << ""
                                << "sonars";
        QTest::newRow("one sonar of nine") << true << "R1"
                                           << "sonar R1";
        QTest::newRow("INS") << false << ""
                             << "INS";
    }
    void waitsForASilentSensorThenAsksForAHand() {
        QFETCH(bool, sonars);
        QFETCH(QString, one_sonar);
        QFETCH(QString, named);
        ToyFaults faults;
        faults.only_silent_sonar = one_sonar.toStdString();
        (sonars ? faults.sonars_silent_after_s : faults.ins_silent_after_s) = 60.0;
        ToyFlight toy = flight({}, field_task, {}, faults);
        toy.run(Seconds(200));
        QVERIFY(toy.ending());
        QVERIFY(!toy.ending()->success);
        QVERIFY(contains(toy.events(), "The " + named.toStdString() + " went silent"));
        QVERIFY(toy.robot().position_m().z() > 3.0); // where it was, not on the ground
    }

    void fliesOnTheStockLayoutWhenNobodyAnswers() {
        ToyFlight toy = flight({}, field_task, {}, {.silent_geometry = true, .no_response = true});
        toy.run(Seconds(1000));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY(contains(toy.events(), "stock AirRobot"));
    }

    void refusesAnEmptyAreaOnTheGround() {
        ToyFlight toy = flight({}, {"R1", Pose{}, {Vec2(5, 5), Vec2(5, 35)}});
        toy.run(Seconds(60));
        QVERIFY(toy.ending());
        QVERIFY(!toy.ending()->success);
        QVERIFY(toy.robot().onGround());
    }

    void saysWhyBehindEveryCommand() {
        ToyFlight toy = flight({});
        toy.run(Seconds(120));
        QVERIFY(!toy.commands().empty());
        for (const CausedCommand& caused : toy.commands()) {
            QVERIFY(caused.cause.trigger.value > 0);
            QVERIFY(toText(caused.cause.source).size() > std::string("airrobot/test: ").size());
        }
    }

    void estimatesTheTimeThatIsLeft() {
        ToyFlight toy = flight({});
        toy.run(Seconds(100));
        const Seconds promised = *toy.status().time_left;
        const Seconds then = toy.robot().now();
        toy.run(Seconds(1000));
        const Seconds really = toy.robot().now() - then;
        QVERIFY2(promised > really * 0.6 && promised < really * 1.6,
                 qPrintable(QString("%1 s promised, %2 s really").arg(promised.count()).arg(really.count())));
    }
};

USAR_TEST(tst_SurveyBehavior)

} // namespace tst_survey_behavior

#include "tst_survey_behavior.moc"
