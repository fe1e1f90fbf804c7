#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTest>

#include "robots/p2dx/descriptions.h"
#include "tests/doubles/toy_p2dx.h"
#include "tests/suite/suite.h"

namespace tst_p2dx_explorer {

using namespace usar;
using namespace usar::agent;
using namespace usar::test;

namespace {

/// Who decides: every test runs with each of them.
std::string decider = "p2dx/cpp";

ToyDrive driveIn(const ToyRoom& room, const Pose& start_in_map = {},
                 const std::map<std::string, ParameterValue>& values = {}, const Rectangle& area_in_map = {}) {
    const auto parameters = ParameterSet::make(p2dx::P2dxRobot().description().behaviors[0].parameters, values);
    Q_ASSERT(parameters);
    auto behavior = p2dx::P2dxRobot().createBehavior(decider, {{"R1", start_in_map, area_in_map}, *parameters});
    Q_ASSERT(behavior);
    return {ToyP2dx(room, start_in_map), std::move(*behavior)};
}

Pose facing(double x_m, double y_m, double yaw_deg) {
    return {{x_m, y_m, 0.0}, 0.0, 0.0, radians(yaw_deg)};
}

ToyRoom hall() {
    ToyRoom room;
    room.walls_m = {{-8.0, -5.0}, {8.0, 5.0}};
    room.boxes = {{{{2.0, 1.0}, {2.6, 1.6}}},
                  {{{-4.0, -2.0}, {-3.4, -1.4}}},
                  {{{-2.0, 3.0}, {4.0, 4.0}}, true},
                  {{{5.0, -5.0}, {5.2, -1.0}}}};
    return room;
}

const protocol::SkidDrive& lastDrive(const ToyDrive& toy) {
    return std::get<protocol::SkidDrive>(toy.commands().back().command);
}

} // namespace

class tst_P2dxExplorer : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data() {
        QTest::addColumn<QByteArray>("behavior");
        QTest::newRow("coded") << QByteArray("p2dx/cpp");
        QTest::newRow("POSH plan") << QByteArray("p2dx/posh");
    }
    void init() {
        QFETCH_GLOBAL(QByteArray, behavior);
        decider = behavior.toStdString();
    }

    void headsForTheMostOpenThird_data() {
        QTest::addColumn<double>("yaw_deg");
        QTest::addColumn<QString>("state");
        QTest::newRow("ahead") << 0.0 << "heading ahead";
        QTest::newRow("left") << -60.0 << "heading left";
        QTest::newRow("right") << 60.0 << "heading right";
    }
    void headsForTheMostOpenThird() {
        QFETCH(double, yaw_deg);
        QFETCH(QString, state);
        ToyRoom corridor;
        corridor.walls_m = {{-3.0, -3.0}, {15.0, 3.0}};
        ToyDrive toy = driveIn(corridor, facing(0.0, 0.0, yaw_deg));
        toy.run(Seconds(2.0));
        QCOMPARE(toy.status().state, std::string("at rest"));
        toy.run(Seconds(1.4));
        QCOMPARE(toy.status().state, state.toStdString());
        const double left_rad_s = *lastDrive(toy).left_rad_s;
        const double right_rad_s = *lastDrive(toy).right_rad_s;
        QVERIFY(left_rad_s > 0.0 && right_rad_s > 0.0);
        QCOMPARE(left_rad_s < right_rad_s, state == "heading left");
        QCOMPARE(left_rad_s > right_rad_s, state == "heading right");
    }

    void reversesAwayFromTheNearerSideAndTurnsOn_data() {
        QTest::addColumn<double>("y_m");
        QTest::addColumn<bool>("left");
        QTest::newRow("the left wall is nearer") << 0.15 << false;
        QTest::newRow("the right wall is nearer") << -0.15 << true;
    }
    void reversesAwayFromTheNearerSideAndTurnsOn() {
        QFETCH(double, y_m);
        QFETCH(bool, left);
        ToyRoom passage; // with a dead end
        passage.walls_m = {{-3.0, -0.7}, {3.0, 0.7}};
        ToyDrive toy = driveIn(passage, facing(1.0, y_m, 0.0), {{"side_lead_pct", 100.0}});
        QVERIFY(toy.runInto("backing away"));
        const double left_rad_s = *lastDrive(toy).left_rad_s;
        const double right_rad_s = *lastDrive(toy).right_rad_s;
        QVERIFY(left_rad_s < 0.0 && right_rad_s < 0.0);
        QCOMPARE(right_rad_s > left_rad_s, left);
        QVERIFY(toy.runInto(left ? "turning left" : "turning right"));
        QVERIFY(toy.runInto("heading ahead"));
        QVERIFY(std::abs(toy.robot().yaw_rad()) > radians(60.0));
        QCOMPARE(toy.robot().collisions(), 0);
    }

    void backsOnlyOverGroundThatItHasCrossed() {
        ToyRoom cell;
        cell.walls_m = {{-0.4, -2.0}, {0.5, 2.0}}; // a wall in front of it, and one behind
        ToyDrive toy = driveIn(cell);
        toy.run(Seconds(6.0));
        QCOMPARE(toy.status().state, std::string("heading ahead")); // along the walls
        for (const CausedCommand& caused : toy.commands()) {
            const auto& drive = std::get<protocol::SkidDrive>(caused.command);
            QVERIFY(*drive.left_rad_s + *drive.right_rad_s > -1e-9);
        }
        QCOMPARE(toy.robot().collisions(), 0);
    }

    void standsWhileTheScanIsOld() {
        ToyDrive toy = driveIn({});
        toy.run(Seconds(6.0));
        toy.robot().scanner_silent = true;
        toy.run(Seconds(1.8));
        QVERIFY(*lastDrive(toy).left_rad_s > 0.0);
        toy.run(Seconds(0.6));
        QCOMPARE(*lastDrive(toy).left_rad_s, 0.0);
        QCOMPARE(toy.status().state, std::string("waiting for a scan"));
        toy.run(Seconds(60.0));
        QCOMPARE(*lastDrive(toy).left_rad_s, 0.0);
        QCOMPARE(toy.events().size(), std::size_t(1));
        toy.robot().scanner_silent = false;
        toy.run(Seconds(1.0));
        QVERIFY(*lastDrive(toy).left_rad_s > 0.0);
    }

    void standsWhileTheScannerIsFrozen() {
        ToyDrive toy = driveIn(hall());
        toy.run(Seconds(6.0));
        toy.robot().scanner_frozen = true;
        const Vec2 from_m = toy.robot().position_m();
        toy.run(Seconds(2.0));
        QCOMPARE(toy.status().state, std::string("waiting for another scan"));
        QVERIFY((toy.robot().position_m() - from_m).norm() < 0.5);
        QVERIFY(toy.events().size() == 1 && toy.events().front().starts_with("The range scanner is frozen"));
        toy.run(Seconds(60.0));
        QCOMPARE(*lastDrive(toy).left_rad_s, 0.0);
        QCOMPARE(toy.events().size(), std::size_t(1));
        toy.robot().scanner_frozen = false;
        toy.run(Seconds(1.0));
        QVERIFY(*lastDrive(toy).left_rad_s > 0.0);
    }

    /// Empty scans are alike however far it moves, frozen or not.
    void whereNothingIsInReachAFrozenScannerIsNotNoticedAndItsSonarsTurnItBack() {
        ToyDrive toy = driveIn({}); // walls 50 m away
        toy.run(Seconds(6.0));
        toy.robot().scanner_frozen = true;
        QVERIFY(toy.runInto("backing away"));
        QVERIFY(toy.robot().position_m().cwiseAbs().maxCoeff() > 45.0);
        QCOMPARE(toy.robot().collisions(), 0);
        QVERIFY(toy.events().empty());
    }

    void aScanThatStaysTheSameAtRestIsNoTrouble() {
        ToyDrive toy = driveIn(hall()); // its scans have no noise
        toy.order(Order::Pause);
        toy.run(Seconds(30.0));
        QCOMPARE(toy.status().state, std::string("paused"));
        toy.order(Order::Resume);
        toy.run(Seconds(1.0));
        QVERIFY(*lastDrive(toy).left_rad_s > 0.0);
        QVERIFY(toy.events().empty());
    }

    void hearsWhatLiesBelowItsScanner() {
        ToyRoom room;
        room.boxes = {{{{3.0, -5.0}, {4.0, 5.0}}, true}};
        ToyDrive toy = driveIn(room);
        QVERIFY(toy.runInto("backing away"));
        QVERIFY(toy.robot().position_m().x() > 2.0);
        toy.run(Seconds(60.0));
        QCOMPARE(toy.robot().collisions(), 0);
    }

    void turnsBackWhereTheGroundFallsSteeply() {
        ToyRoom room;
        room.ground_m = [](const Vec2& at_m) { return at_m.x() < 3.0 ? 0.0 : -0.4 * (at_m.x() - 3.0); };
        ToyDrive toy = driveIn(room);
        QVERIFY(toy.runInto("backing away"));
        const double edge_m = toy.robot().position_m().x();
        QVERIFY2(edge_m > 3.0 && edge_m < 3.6, qPrintable(QString::number(edge_m)));
        QVERIFY(toy.runInto("heading ahead"));
        QVERIFY(toy.robot().position_m().x() < edge_m);
    }

    void staysInItsArea() {
        const Rectangle area_in_map{{-4.0, -3.0}, {4.0, 3.0}};
        ToyDrive toy = driveIn({}, {}, {}, area_in_map);
        for (int second = 0; second < 600; ++second) {
            toy.run(Seconds(1.0));
            QVERIFY(area_in_map.contains(toy.robot().position_m()));
        }
        QVERIFY(toy.status().distance_flown_m > 100.0);
    }

    void roamsAHallWithoutATouchOrATrap_data() {
        QTest::addColumn<double>("yaw_deg");
        for (const double yaw_deg : {0.0, 37.0, 111.0, 200.0, 290.0})
            QTest::newRow(qPrintable(QString("setting out at %1 degrees").arg(yaw_deg))) << yaw_deg;
    }
    void roamsAHallWithoutATouchOrATrap() {
        QFETCH(double, yaw_deg);
        ToyDrive toy = driveIn(hall(), facing(0.0, 0.0, yaw_deg));
        toy.run(Seconds(1800.0));
        QCOMPARE(toy.robot().collisions(), 0);
        QVERIFY2(toy.robot().longestStay() < Seconds(60.0),
                 qPrintable(QString::number(toy.robot().longestStay().count())));
        QVERIFY(toy.status().distance_flown_m > 300.0);
    }

    void turnsAroundWhereItGetsNoFurther() {
        ToyDrive toy = driveIn({});
        toy.run(Seconds(5.0));
        toy.robot().stuck = true;
        QVERIFY(toy.runInto("turning left"));
        QVERIFY(toy.runInto("heading ahead"));
        QVERIFY(toy.runInto("backing away")); // for turning did not help
        toy.robot().stuck = false;
        const Vec2 freed_m = toy.robot().position_m();
        toy.run(Seconds(60.0));
        QVERIFY((toy.robot().position_m() - freed_m).norm() > 2.0);
    }

    void standsWhilePausedAndGoesOn() {
        ToyDrive toy = driveIn({});
        toy.run(Seconds(6.0));
        toy.order(Order::Pause);
        toy.run(Seconds(1.0));
        const Vec2 stands_m = toy.robot().position_m();
        toy.run(Seconds(120.0));
        QVERIFY(toy.robot().position_m() == stands_m);
        QVERIFY(toy.status().paused);
        QCOMPARE(toy.status().state, std::string("paused"));
        toy.order(Order::Resume);
        toy.run(Seconds(1.0));
        QCOMPARE(toy.status().state, std::string("heading ahead")); // it was no trap
    }

    void stopsForGoodWhenAsked() {
        ToyDrive toy = driveIn({});
        toy.run(Seconds(6.0));
        toy.order(Order::LandNow);
        toy.run(Seconds(1.0));
        QVERIFY(toy.ending());
        QVERIFY(!toy.ending()->success);
        QCOMPARE(*lastDrive(toy).left_rad_s, 0.0);
    }

    void endsAfterItsTime() {
        ToyDrive toy = driveIn({}, {}, {{"drive_time_s", 30.0}});
        toy.run(Seconds(15.0));
        QVERIFY(std::abs(*toy.status().progress_pct - 49.3) < 1.0);
        toy.run(Seconds(60.0));
        QVERIFY(toy.ending() && toy.ending()->success);
        QVERIFY2(toy.ending()->reason.starts_with("Drove for 30 s and 13."), toy.ending()->reason.c_str());
        QCOMPARE(*lastDrive(toy).left_rad_s, 0.0);
    }

    void takesNewParametersOnTheWay() {
        const auto specs = p2dx::P2dxRobot().description().behaviors[0].parameters;
        auto behavior = p2dx::P2dxRobot().createBehavior(decider, {{}, *ParameterSet::make(specs)});
        QVERIFY(behavior);
        Behavior& itself = **behavior;
        ToyDrive toy(ToyP2dx({}, {}), std::move(*behavior));
        toy.run(Seconds(6.0));
        itself.setParameters(*ParameterSet::make(specs, {{"cruise_speed_m_s", 0.2}}));
        toy.run(Seconds(1.0));
        QCOMPARE(*lastDrive(toy).left_rad_s, 0.2 / 0.097);
    }

    void saysWhyBehindEveryCommand() {
        ToyDrive toy = driveIn(hall());
        toy.run(Seconds(60.0));
        QVERIFY(!toy.commands().empty());
        for (const CausedCommand& caused : toy.commands()) {
            QVERIFY(caused.cause.trigger.value > 0);
            QVERIFY(toText(caused.cause.source).size() > std::string("p2dx/test: ").size());
        }
    }

    void bothDecidersSayTheSame() {
        ToyDrive toy = driveIn(hall());
        decider = decider == "p2dx/cpp" ? "p2dx/posh" : "p2dx/cpp";
        ToyDrive twin = driveIn(hall());
        for (ToyDrive* one : {&toy, &twin}) {
            one->run(Seconds(600.0));
            one->robot().stuck = true;
            one->run(Seconds(120.0));
        }
        QCOMPARE(toy.commands().size(), twin.commands().size());
        for (std::size_t i = 0; i < toy.commands().size(); ++i)
            QVERIFY(toy.commands()[i].command == twin.commands()[i].command);
    }

    void refusesABehaviorThatItHasNotAndAPlanThatDoesNotFit() {
        const auto parameters = ParameterSet::make(p2dx::P2dxRobot().description().behaviors[0].parameters);
        const auto other = p2dx::P2dxRobot().createBehavior("p2dx/dance", {{}, *parameters});
        QVERIFY(!other && other.error().text().find("p2dx/posh") != std::string::npos);
        const PlanText wrong{"mine.lap", "((DC P2DX (drives ((a Revers)))))"};
        const auto misspelt = p2dx::P2dxRobot().createBehavior("p2dx/posh", {{}, *parameters, wrong});
        QVERIFY(!misspelt);
        QVERIFY2(misspelt.error().text().find("Reverse") != std::string::npos, misspelt.error().text().c_str());
    }
};

USAR_TEST(tst_P2dxExplorer)

} // namespace tst_p2dx_explorer

#include "tst_p2dx_explorer.moc"
