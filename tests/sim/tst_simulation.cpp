#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/robots/robot_watches.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_simulation {

using namespace usar;
using namespace usar::sim;

namespace {

using Lines = std::vector<std::string>;

const std::string init_on_ground = "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-0.3} {Rotation 0,0,0}";
const std::string init_in_air = "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-6} {Rotation 0,0,0}";
const std::string climb = "DRIVE {AltitudeVelocity 1} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}";

World startWorld() {
    World world = flatWorld();
    world.start_poses.push_back({"Clearing", Pose{{1.0, 2.0, 0.3}, 0.0, 0.0, radians(90.0)}});
    world.start_poses.push_back({"Edge", Pose{{-20.0, 5.0, 0.3}, 0.0, 0.0, 0.0}});
    world.boxes.push_back({Pose{{20.0, 20.0, 3.0}, 0.0, 0.0, 0.0}, {6.0, 6.0, 6.0}});
    return world;
}

bool anyContains(const Lines& lines, const std::string& text) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

} // namespace

class tst_Simulation : public QObject {
    Q_OBJECT

private slots:
    void speaksFirst() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        QCOMPARE(talker.hearText(), Lines{"NFO {Gametype BotDeathMatch} {Level tiny} {TimeLimit 0}"});
        steps(*simulation, 3);
        QCOMPARE(talker.hearText(), Lines{}); // and nothing more until it is asked
    }

    void tellsStartPosesAtOnce() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.hearText();
        talker.say("GETSTARTPOSES");
        const QString answer = QString::fromStdString(talker.hearText().front()).replace("-0.00", "0.00");
        QCOMPARE(answer, QString("NFO {StartPoses 2} {Clearing 1.00,-2.00,-0.30 0.00,0.00,-1.57 "
                                 "Edge -20.00,-5.00,-0.30 0.00,0.00,0.00}"));
    }

    void firstTickBringsOnlyWhatNeedsNoHistory() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.hearText();
        talker.say(init_on_ground);
        QCOMPARE(talker.hearText(), Lines{});
        simulation->step();
        QCOMPARE(kindsOf(talker.hearText()), (Lines{"SEN GroundTruth", "STA"}));
        for (int i = 0; i < 3; ++i) {
            simulation->step();
            QCOMPARE(kindsOf(talker.hearText()),
                     (Lines{"SEN Sonar", "SEN RangeScanner", "SEN INS", "SEN GroundTruth", "STA"}));
        }
    }

    void knowsHowFarARobotCameAndHowLongItStayed() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say(init_p2dx);
        steps(*simulation, 25);
        talker.say("DRIVE {Left 5} {Right 5}");
        steps(*simulation, 50);
        const RobotTruth truth = simulation->robots().front();
        QCOMPARE(truth.collisions, 0);
        QVERIFY(std::abs(truth.distance_m - 10.0 * 5.0 * 0.097) < 0.4);
        QVERIFY(truth.longest_stay > Seconds{6.0} && truth.longest_stay < Seconds{8.0}); // and the first metre
    }

    void writesTimeWithTheDecimalsOfEachType() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say(init_on_ground);
        steps(*simulation, 1);
        talker.hearText();
        steps(*simulation, 1);
        const Lines lines = talker.hearText();
        QVERIFY(QString::fromStdString(lines[0]).startsWith("SEN {Time 0.4000} {Type Sonar} {Name L4 Range "));
        QVERIFY(QString::fromStdString(lines[1]).startsWith(
            "SEN {Time 0.40} {Type RangeScanner} {Name Scanner1} {Resolution 0.0174} {FOV 3.1415} {Range "));
        QVERIFY(QString::fromStdString(lines[2]).startsWith("SEN {Type INS} {Name INS} {Location 0.00,"));
        QVERIFY(QString::fromStdString(lines[3]).startsWith("SEN {Time 0.4000} {Type GroundTruth} "));
        QCOMPARE(lines[4], std::string("STA {Type AerialVehicle} {Time 0.40} {LightToggle False} {LightIntensity 0} "
                                       "{Battery 1200} {View -1}"));
    }

    void spawnsWhereItIsTold_data() {
        QTest::addColumn<QString>("init");
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<double>("yaw_deg");
        const QString air = "INIT {ClassName USARBot.AirRobot} {Name R} ";
        QTest::newRow("location on the wire")
            << air + "{Location 3,-4,-2} {Rotation 0,0,-0.5236}" << 3.0 << 4.0 << 30.0;
        QTest::newRow("spaces in the vector") << air + "{Location 3 -4 -2}" << 3.0 << 4.0 << 0.0;
        QTest::newRow("start pose") << air + "{Start Clearing}" << 1.0 << 2.0 << 90.0;
        QTest::newRow("start pose in another case") << air + "{Start EDGE}" << -20.0 << 5.0 << 0.0;
        QTest::newRow("start pose over location") << air + "{Start Edge} {Location 1,1,-3}" << -20.0 << 5.0 << 0.0;
        QTest::newRow("unknown start falls back") << air + "{Start Nowhere} {Location 7,8,-3}" << 7.0 << -8.0 << 0.0;
        QTest::newRow("bare class") << "INIT {ClassName airrobot} {Location 1,0,-3}" << 1.0 << 0.0 << 0.0;
        QTest::newRow("in the ground by a foot") << air + "{Location 5,5,0.3}" << 5.0 << -5.0 << 0.0;
    }
    void spawnsWhereItIsTold() {
        QFETCH(QString, init);
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(double, yaw_deg);
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say(init.toStdString());
        steps(*simulation, 20);
        QCOMPARE(simulation->robots().size(), 1u);
        const Pose pose = simulation->robots().front().base_in_map;
        QVERIFY((pose.position_m.head<2>() - Vec2(x_m, y_m)).norm() < 0.02);
        QVERIFY(std::abs(degrees(pose.yaw_rad) - yaw_deg) < 0.5);
        QVERIFY(pose.position_m.z() > 0.2);
        QVERIFY(!simulation->robots().front().broken);
    }

    void twoRobotsOnOneStartPoseStandSideBySide_data() {
        QTest::addColumn<QString>("where");
        QTest::newRow("a start pose") << "{Start Clearing}";
        QTest::newRow("on the ground beside a house") << "{Location 16,-20,-0.3}";
        QTest::newRow("in the air") << "{Location 0,0,-6}";
        QTest::newRow("near the ground, over the first one") << "{Location 4,4,-0.9}";
        QTest::newRow("in the ground by a foot") << "{Location 5,5,0.3}";
    }
    void twoRobotsOnOneStartPoseStandSideBySide() {
        QFETCH(QString, where);
        const std::string init = "INIT {ClassName USARBot.AirRobot} {Name R} " + where.toStdString();
        const auto simulation = simulationOf(startWorld());
        Talker first(*simulation);
        first.say(init);
        steps(*simulation, 20);
        Talker second(*simulation);
        second.say(init);
        steps(*simulation, 20);
        QVERIFY(anyContains(simulation->takeLog(), "beside the wanted place"));
        first.say(climb);
        second.say(climb);
        steps(*simulation, 20);
        const auto robots = simulation->robots();
        QCOMPARE(robots.size(), 2u);
        for (const RobotTruth& robot : robots) {
            QVERIFY(!robot.broken);
            QCOMPARE(robot.collisions, 0);
            QVERIFY(robot.base_in_map.position_m.z() > 2.0);
        }
        const double apart_m = (robots[0].base_in_map.position_m - robots[1].base_in_map.position_m).norm();
        QVERIFY2(apart_m > 1.7 && apart_m < 4.5, qPrintable(QString::number(apart_m)));
    }

    void robotsThatAppearInOneTickShareAStartPose() {
        const auto simulation = simulationOf(startWorld());
        std::vector<Talker> talkers;
        for (int i = 0; i < 4; ++i)
            talkers.emplace_back(*simulation).say("INIT {ClassName AirRobot} {Start Edge}");
        steps(*simulation, 20);
        const auto robots = simulation->robots();
        QCOMPARE(robots.size(), 4u);
        QVERIFY(std::ranges::none_of(robots, [](const RobotTruth& robot) { return robot.broken; }));
    }

    void aStartPoseWithoutRoomLeftRefusesTheNextRobot() {
        const auto simulation = simulationOf(startWorld());
        std::vector<Talker> talkers;
        for (int i = 0; i < 40; ++i)
            talkers.emplace_back(*simulation).say("INIT {ClassName AirRobot} {Start Clearing}");
        steps(*simulation, 20);
        const auto robots = simulation->robots();
        QVERIFY(robots.size() > 6 && robots.size() < 40);
        QVERIFY(std::ranges::none_of(robots, [](const RobotTruth& robot) { return robot.broken; }));
        QVERIFY(anyContains(simulation->takeLog(), "clear of trees and of other robots"));
    }

    void refusesAndTellsTheLog_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("logged");
        QTest::newRow("unknown class") << "INIT {ClassName USARBot.Fountain} {Location 0,0,-1}"
                                       << "unknown robot class";
        QTest::newRow("inside a house") << "INIT {ClassName USARBot.AirRobot} {Location 20,-20,-2}"
                                        << "no room";
        QTest::newRow("deep underground") << "INIT {ClassName USARBot.AirRobot} {Location 0,0,9}"
                                          << "no room";
        QTest::newRow("drive without a robot") << "DRIVE {AltitudeVelocity 1}"
                                               << "no robot";
        QTest::newRow("question without a robot") << "GETCONF {Type Robot}"
                                                  << "no robot";
        QTest::newRow("INIT without class") << "INIT {Name R}"
                                            << "ClassName";
        QTest::newRow("nonsense") << "EHLO example.org"
                                  << "EHLO";
    }
    void refusesAndTellsTheLog() {
        QFETCH(QString, line);
        QFETCH(QString, logged);
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.hearText();
        talker.say(line.toStdString());
        steps(*simulation, 3);
        const Lines heard = talker.hearText();
        for (const std::string& one : heard)
            QVERIFY2(line.startsWith("INIT") && one.starts_with("RES ") && one.find("{Status Failed}") != one.npos,
                     one.c_str());
        QVERIFY(anyContains(simulation->takeLog(), logged.toStdString()));
        QVERIFY(simulation->robots().empty());
        talker.say(init_on_ground);
        simulation->step();
        QCOMPARE(simulation->robots().size(), 1u); // the connection lives
    }

    void ignoresASecondInit() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say(init_on_ground);
        simulation->step();
        talker.say("INIT {ClassName USARBot.AirRobot} {Name R2} {Location 9,9,-3}");
        simulation->step();
        QCOMPARE(simulation->robots().size(), 1u);
        QCOMPARE(simulation->robots().front().name, std::string("R1"));
        QVERIFY(anyContains(simulation->takeLog(), "second INIT"));
    }

    void ignoresWhatIsForOtherRobotsAndTellsTheLog_data() {
        QTest::addColumn<QString>("line");
        for (const char* line : {"DRIVE {Speed 3} {FrontSteer 0.5}", "MULTIDRIVE {FLFlipper 0.5}",
                                 "MISPKG {Name CameraPanTilt} {Link 1} {Value 1.5}", "GETPATHNODES",
                                 "ACT {Name Arm} {Gripper 1}", "EHLO example.org"})
            QTest::newRow(line) << line;
    }
    void ignoresWhatIsForOtherRobotsAndTellsTheLog() {
        QFETCH(QString, line);
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say(init_on_ground);
        talker.say(line.toStdString());
        simulation->step();
        QCOMPARE(simulation->robots().size(), 1u);
        QVERIFY(anyContains(simulation->takeLog(), "not a command of this server"));
    }

    void fliesAsItIsDriven() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say(init_on_ground);
        steps(*simulation, 20);
        talker.say(climb);
        steps(*simulation, 20);
        talker.say("DRIVE {AltitudeVelocity 0} {LateralVelocity 25} {Normalized true}"); // half a meter a second, right
        steps(*simulation, 30);
        const auto truth = talker.hearLast<protocol::GroundTruthReading>();
        QVERIFY(truth && truth->base_in_map.position_m.z() > 2.5);
        QVERIFY(truth->base_in_map.position_m.y() < -1.5);
        const RobotTruth robot = simulation->robots().front();
        QVERIFY(std::abs(robot.velocity_in_map_m_s.y() + 0.5) < 0.05);
        QVERIFY((robot.base_in_map.position_m - truth->base_in_map.position_m).norm() < 0.01);
        QVERIFY(robot.distance_m > 4.0 && robot.distance_m < 7.0);
        QCOMPARE(robot.collisions, 0);
    }

    void scannerLooksStraightDownAndTheSonarsSeeTheHouse() {
        SimulationOptions options;
        options.noise = false;
        const auto simulation = simulationOf(startWorld(), options);
        Talker talker(*simulation);
        talker.say("INIT {ClassName AirRobot} {Location 13,-20,-4}"); // 4 m west of the house
        steps(*simulation, 10);
        std::optional<protocol::RangeScan> scan;
        std::optional<protocol::SonarReadings> sonars;
        for (const protocol::InfoLine& line : talker.hear()) {
            if (const auto* const one = std::get_if<protocol::RangeScan>(&line.message))
                scan = *one;
            if (const auto* const one = std::get_if<protocol::SonarReadings>(&line.message))
                sonars = *one;
        }
        QVERIFY(scan && sonars);
        QCOMPARE(scan->ranges_m.size(), 181u);
        QVERIFY(std::abs(scan->ranges_m[90] - 3.9) < 0.01);
        QVERIFY(std::abs(scan->ranges_m[30] - 3.9 / std::cos(radians(60.0))) < 0.02);
        QCOMPARE(sonars->ranges.size(), 9u);
        QCOMPARE(sonars->ranges[0].name, std::string("L4"));
        QCOMPARE(sonars->ranges[4].name, std::string("M0"));
        QVERIFY(std::abs(sonars->ranges[4].range_m - 3.5) < 0.01);
        QCOMPARE(sonars->ranges[0].range_m, 5.0);
    }

    void batteryCountsDownAndItsEndSilencesTheSensors() {
        SimulationOptions options;
        options.battery_life = Seconds{5.0};
        const auto simulation = simulationOf(startWorld(), options);
        Talker talker(*simulation);
        talker.say(init_in_air);
        steps(*simulation, 15); // 3 s
        QCOMPARE(talker.hearLast<protocol::RobotState>()->battery_left, Seconds{2.0});
        steps(*simulation, 15);
        talker.hearText();
        talker.say("GETCONF {Type Robot}");
        talker.say(climb);
        simulation->step();
        const Lines lines = talker.hearText();
        QCOMPARE(kindsOf(lines), Lines{"STA"});
        QVERIFY(anyContains(lines, "{Battery 0}"));
        steps(*simulation, 30);
        QVERIFY(simulation->robots().front().base_in_map.position_m.z() < 1.0);
    }

    void robotLeavesWithItsConnection() {
        const auto simulation = simulationOf(startWorld());
        Talker first(*simulation);
        Talker second(*simulation);
        first.say(init_in_air);
        second.say("INIT {ClassName USARBot.AirRobot} {Name R2} {Location 9,9,-3}");
        steps(*simulation, 2);
        QCOMPARE(simulation->robots().size(), 2u);
        QVERIFY(!simulation->lastGone());
        first.say("DRIVE {AltitudeVelocity 1}");
        steps(*simulation, 10);
        const double way_m = simulation->robots().front().distance_m;
        QVERIFY(way_m > 0.0);
        simulation->disconnect(first.id());
        steps(*simulation, 2);
        QVERIFY(simulation->lastGone());
        QCOMPARE(simulation->lastGone()->name, std::string("R1"));
        QCOMPARE(simulation->lastGone()->distance_m, way_m);
        QCOMPARE(simulation->robots().size(), 1u);
        QCOMPARE(simulation->robots().front().name, std::string("R2"));
        QCOMPARE(simulation->clientCount(), 1u);
        simulation->receive(first.id(), "GETSTARTPOSES\r\n");
        QCOMPARE(simulation->takeOutput(first.id()), std::string());
    }

    void robotsThatMeetInTheAirBreakEachOther() {
        const auto simulation = simulationOf(startWorld());
        Talker first(*simulation);
        Talker second(*simulation);
        first.say(init_in_air);
        second.say("INIT {ClassName AirRobot} {Location -5,0,-6}");
        steps(*simulation, 2);
        second.say("DRIVE {LinearVelocity 2}");
        steps(*simulation, 30);
        for (const RobotTruth& robot : simulation->robots()) {
            QVERIFY(robot.broken);
            QVERIFY(!robot.collision_places_in_map_m.empty());
            const Vec3& place_m = robot.collision_places_in_map_m.front();
            QVERIFY2(place_m.head<2>().norm() < 1.5 && place_m.z() > 4.0, "they met above the origin");
        }
    }

    void theFirstPlacesOfManyCollisionsAreKept() {
        CollisionPlaces places;
        for (int collisions = 0; collisions < 100; ++collisions)
            for (int tick = 0; tick < 3; ++tick)
                places.step(collisions, Vec3(collisions, tick, 0.0));
        QCOMPARE(places.places_m().size(), CollisionPlaces::most);
        QCOMPARE(places.places_m().front(), Vec3(1.0, 0.0, 0.0));
    }

    void fliesOverTheEdgeWithoutHarm() {
        const auto simulation = simulationOf(startWorld());
        Talker talker(*simulation);
        talker.say("INIT {ClassName AirRobot} {Location 30,0,-5}");
        talker.say("DRIVE {LinearVelocity 2}");
        steps(*simulation, 100);
        const auto scan = talker.hearLast<protocol::RangeScan>();
        QVERIFY(scan);
        QCOMPARE(scan->ranges_m[90], 20.0);
        QVERIFY(simulation->robots().front().base_in_map.position_m.x() > 60.0);
    }

    void learnsRobotsWhileOthersDrive() {
        const auto simulation = simulationOf(startWorld());
        Talker first(*simulation);
        first.say(init_p2dx);
        first.say("DRIVE {Left 2} {Right 2}");
        steps(*simulation, 5);
        RobotModel own = *findRobot(*doubles::shippedRobots(), "P2DX");
        simulation->learn(own); // the one that drives is of the former
        own.class_name = "Own";
        simulation->learn(own);
        const double before_m = simulation->robots().front().base_in_map.position_m.x();
        Talker second(*simulation);
        second.say("INIT {ClassName USARBot.Own} {Name R2} {Location 0,-4,-0.2}");
        steps(*simulation, 5);
        QCOMPARE(simulation->robots().size(), std::size_t(2));
        QVERIFY(simulation->robots().front().base_in_map.position_m.x() > before_m + 0.05);
        QVERIFY(anyContains(second.hearText(), "STA {Type GroundVehicle}"));
    }

    void aWorldThatWasPreparedBeforeServesAsWell() {
        const auto usual = simulationOf(startWorld());
        auto prepared = PreparedWorld::make(startWorld());
        QVERIFY(prepared);
        PreparedWorld elsewhere = *std::move(prepared); // What was made of the world refers to it.
        const auto simulation =
            Simulation::make(std::move(elsewhere), {.robots = doubles::shippedRobots(), .keeps_journal = false});
        QVERIFY(simulation);
        const std::string heard = heardBy(**simulation, init_on_ground.c_str(), 50);
        QVERIFY(heard.size() > 10000);
        QVERIFY(heard == heardBy(*usual, init_on_ground.c_str(), 50));
    }

    void aWorldWithoutGroundIsRefused() {
        QVERIFY(!PreparedWorld::make(World{}));
        const auto made = Simulation::make(World{});
        QVERIFY(!made);
        QVERIFY(made.error().text().find("there is nothing to stand on") != std::string::npos);
    }
};

USAR_TEST(tst_Simulation)

} // namespace tst_simulation

#include "tst_simulation.moc"
