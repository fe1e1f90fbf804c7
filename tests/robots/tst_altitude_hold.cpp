#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/altitude_hold.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_altitude_hold {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_AltitudeHold : public QObject {
    Q_OBJECT

    Settings settings;
    const MemorySpans spans{};

private slots:
    void keepsTheScanAltitudeOverTheGround() {
        const Senses senses = sensesAt({0, 0, 9});
        QCOMPARE(altitudeGoal_m(senses, ObstacleMemory(), 0.0, 1.0, {}, settings), 3.0 + settings.scan_altitude_m);
    }

    void neverGoesBelowTheFloor() {
        settings.floor_level_m = 5.0;
        const Senses senses = sensesAt({0, 0, 6}); // ground at 0
        settings.scan_altitude_m = 3.0;
        QCOMPARE(altitudeGoal_m(senses, ObstacleMemory(), 0.0, 1.0, {}, settings), 5.0);
        settings = {};
    }

    void allowsForTheDriftOfItsHeightWhereThereMayBeWater_data() {
        QTest::addColumn<bool>("ground_in_reach");
        QTest::addColumn<double>("ground_m");
        QTest::addColumn<double>("higher_m");
        QTest::newRow("no ground in reach") << false << 0.0 << 3.0;
        QTest::newRow("ground that may be the bed of water") << true << -4.0 << 3.0;
        QTest::newRow("dry ground") << true << 0.0 << 0.0;
    }
    void allowsForTheDriftOfItsHeightWhereThereMayBeWater() {
        QFETCH(bool, ground_in_reach);
        QFETCH(double, ground_m);
        QFETCH(double, higher_m);
        Settings low;
        low.floor_level_m = 2.5;
        low.scan_altitude_m = 2.0;
        Senses senses = sensesAt({0, 0, 3});
        senses.height_doubt_m = 3.0;
        senses.ground_m = ground_in_reach ? std::optional(ground_m) : std::nullopt;
        QCOMPARE(altitudeGoal_m(senses, ObstacleMemory(), 0.0, 1.0, {}, low), low.floor_level_m + higher_m);
    }

    void sinksTowardTheFloorWhereNothingIsInReach() {
        Senses senses = sensesAt({0, 0, 30});
        senses.ground_m.reset();
        QCOMPARE(altitudeGoal_m(senses, ObstacleMemory(), 0.0, 1.0, {}, settings), 29.0);
    }

    void staysClearOfATipBesideTheMiddleRays() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{{1}, {}, {}, {Vec3(0, 1.2, 5.0)}}; // a tip that the mean of the middle rays ignores
        memory.take(senses, spans);
        QCOMPARE(altitudeGoal_m(senses, memory, 0.0, 1.0, {}, settings), 5.0 + settings.clearance_m);
    }

    void doesNotRiseForATrunkBesideIt() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{{1}, {}, {}, {Vec3(0, 1.5, 5.9)}};
        memory.take(senses, spans);
        QCOMPARE(altitudeGoal_m(senses, memory, 0.0, 1.0, {}, settings), settings.scan_altitude_m);
    }

    void risesForWhatIsKnownAheadOnly_data() {
        QTest::addColumn<double>("bearing_deg");
        QTest::addColumn<bool>("rises");
        QTest::newRow("toward it") << 0.0 << true;
        QTest::newRow("past it") << 60.0 << false;
        QTest::newRow("away from it") << 180.0 << false;
    }
    void risesForWhatIsKnownAheadOnly() {
        QFETCH(double, bearing_deg);
        QFETCH(bool, rises);
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{{1}, {}, {}, {Vec3(6, 0, 5.0)}};
        memory.take(senses, spans);
        QCOMPARE(altitudeGoal_m(senses, memory, radians(bearing_deg), 1.0, {}, settings) > 6.1, rises);
    }

    /// On its way, it sank from above the masts of a street into the wire between them (random surveys 165470, 166326).
    void staysAboveTheWiresThatMastsMayCarry_data() {
        QTest::addColumn<double>("thing_m"); // its half width
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("from_m");
        QTest::addColumn<double>("goal_m");
        QTest::newRow("a mast") << 0.0 << 8.0 << 12.0 << 9.0;
        QTest::newRow("no mast") << -1.0 << 8.0 << 12.0 << 6.0;
        QTest::newRow("a tree") << 1.2 << 8.0 << 12.0 << 6.0;
        QTest::newRow("a mast far away") << 0.0 << 14.0 << 12.0 << 6.0;
        QTest::newRow("a mast, from below its top") << 0.0 << 8.0 << 7.5 << 6.0;
    }
    void staysAboveTheWiresThatMastsMayCarry() {
        QFETCH(double, thing_m);
        QFETCH(double, x_m);
        QFETCH(double, from_m);
        QFETCH(double, goal_m);
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, from_m});
        setFlatScan(senses, {x_m, 0}, 3.0, 0.0);
        for (double y_m = -thing_m; y_m <= thing_m; y_m += 0.3)
            for (double along_m = -thing_m; along_m <= thing_m; along_m += 0.3)
                senses.scan->hits_in_map_m.emplace_back(x_m + 0.1 + along_m, 0.1 + y_m, 8.0);
        memory.take(senses, spans);
        QCOMPARE(aboveWires_m(senses, memory, settings.scan_altitude_m), goal_m);
    }

    void keepsTheHeightOfAClimbOver() {
        QCOMPARE(altitudeGoal_m(sensesAt({0, 0, 6}), ObstacleMemory(), 0.0, 1.0, 14.0, settings), 14.0);
    }

    void leavesSmallErrorsAlone() {
        AltitudeHold hold;
        QCOMPARE(hold.climbRate_m_s(sensesAt({0, 0, 6}), ObstacleMemory(), 6.2, 0.0, 1.0, settings), 0.0);
        QVERIFY(hold.climbRate_m_s(sensesAt({0, 0, 6}), ObstacleMemory(), 6.5, 0.0, 1.0, settings) > 0.0);
        QVERIFY(hold.climbRate_m_s(sensesAt({0, 0, 6}), ObstacleMemory(), 6.2, 0.0, 1.0, settings) > 0.0);
    }

    void climbsNoFasterThanItMay() {
        AltitudeHold hold;
        QCOMPARE(hold.climbRate_m_s(sensesAt({0, 0, 6}), ObstacleMemory(), 20.0, 0.0, 1.0, settings),
                 settings.climb_speed_m_s);
    }

    void sinksNoSteeperThanTheSonarsSee_data() {
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<bool>("known_ahead");
        QTest::addColumn<bool>("told");
        QTest::addColumn<double>("at_most_m_s");
        QTest::newRow("over unknown ground") << 1.0 << false << false << 0.13;
        QTest::newRow("over ground seen from another lane") << 1.0 << true << false << settings.descent_speed_m_s;
        QTest::newRow("over ground that the caller knows") << 1.0 << false << true << settings.descent_speed_m_s;
        QTest::newRow("straight down") << 0.0 << false << false << settings.descent_speed_m_s;
    }
    void sinksNoSteeperThanTheSonarsSee() {
        QFETCH(double, speed_m_s);
        QFETCH(bool, known_ahead);
        QFETCH(bool, told);
        QFETCH(double, at_most_m_s);
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 16});
        setFlatScan(senses, {known_ahead ? 0.0 : -8.0, 0.0}, 7.0, 0.0);
        memory.take(senses, spans);
        AltitudeHold hold;
        const double rate_m_s = hold.climbRate_m_s(senses, memory, 6.0, 0.0, speed_m_s, settings, told);
        QVERIFY(rate_m_s < 0.0);
        QVERIFY(-rate_m_s <= at_most_m_s + 1e-9);
        if (known_ahead || told || speed_m_s == 0.0)
            QCOMPARE(-rate_m_s, settings.descent_speed_m_s);
    }
};

USAR_TEST(tst_AltitudeHold)

} // namespace tst_altitude_hold

#include "tst_altitude_hold.moc"
