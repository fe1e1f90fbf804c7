// The map of what stands at flying height, ways over it, and the detours that follow them.
#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/detour.h"
#include "robots/airrobot/flight/way_back.h"
#include "robots/airrobot/flight/ways.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_routes {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

constexpr double open_sky_m = 1e9;

class tst_Routes : public QObject {
    Q_OBJECT

    /// A wall from (x, from_y) to (x, to_y), as the scanner sees it.
    static void addWall(RouteMap& map, double x_m, double from_y_m, double to_y_m, double top_m = 8.0) {
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        senses.scan = PlacedScan{{1}, {}, {}, {}};
        for (double y_m = from_y_m; y_m <= to_y_m; y_m += 0.25)
            senses.scan->hits_in_map_m.emplace_back(x_m, y_m, top_m);
        map.take(senses, open_sky_m);
    }
    static void addRow(RouteMap& map, double y_m, double from_x_m, double to_x_m) {
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        senses.scan = PlacedScan{{1}, {}, {}, {}};
        for (double x_m = from_x_m; x_m <= to_x_m; x_m += 0.25)
            senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 8.0);
        map.take(senses, open_sky_m);
    }
    /// Walls around (0, 0), with a gap in the middle of the one in the east.
    static RouteMap room(double gap_m) {
        RouteMap map;
        addWall(map, -10.0, -10.0, 10.0);
        addRow(map, -10.0, -10.0, 10.0);
        addRow(map, 10.0, -10.0, 10.0);
        addWall(map, 10.0, -10.0, -gap_m / 2.0);
        addWall(map, 10.0, gap_m / 2.0, 10.0);
        return map;
    }
    static Senses heard(const std::string& sonar, double range_m) {
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        setSonars(senses, {{sonar, range_m}});
        return senses;
    }

    /// A wall at x = 10 m with a door of 3 m in it, moved along by `drift_m`, as one scan from above shows it at the
    /// heights of the door: beams end in it beside the door, and on the ground behind it.
    static PlacedScan wallWithDoor(double drift_m) {
        PlacedScan scan{{1}, Pose{Vec3(4.0, 0.0, 6.0)}, Pose{Vec3(4.0, 0.0, 6.0)}, {}};
        for (double y_m = -8.0; y_m <= 8.0; y_m += 0.1) {
            const double at_y_m = y_m + drift_m;
            if (std::abs(y_m) > 1.5)
                scan.hits_in_map_m.emplace_back(10.0, at_y_m, 2.4);
            else
                scan.hits_in_map_m.emplace_back(13.0, 1.5 * at_y_m, 0.0);
        }
        return scan;
    }

private slots:
    void knowsWhereTheRobotHasFlown() {
        RouteMap map;
        map.take(sensesAt({3.0, -2.0, 6.0}), open_sky_m);
        QVERIFY(map.wasFlown({3.0, -2.0}));
        QVERIFY(map.wasFlown({3.6, -1.5}));
        QVERIFY(!map.wasFlown({4.6, -2.0}));
        map.clear();
        QVERIFY(!map.wasFlown({3.0, -2.0}));
    }

    void goesAroundAWall() {
        RouteMap map;
        addWall(map, 5.0, -8.0, 3.0);
        const auto way = map.route({0.0, 0.0}, {10.0, 0.0}, 6.0, 1.0);
        QVERIFY(way);
        QVERIFY((way->back() - Vec2(10.0, 0.0)).norm() <= 1.0);
        double farthest_y_m = 0.0;
        Vec2 last_m(0.0, 0.0);
        for (const Vec2& point_m : *way) {
            QVERIFY((point_m - last_m).norm() < 1.2);
            if (point_m.y() <= 3.0)
                QVERIFY(std::abs(point_m.x() - 5.0) >= 1.0);
            farthest_y_m = std::max(farthest_y_m, point_m.y());
            last_m = point_m;
        }
        QVERIFY(farthest_y_m > 4.0); // It takes the short way around the end, and keeps off it.
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 6.0));
        QVERIFY(map.isStraightWayFree({0.0, 0.0}, {0.0, 10.0}, 6.0));
    }

    void knowsThatNoWayLeads_data() {
        QTest::addColumn<double>("gap_m");
        QTest::addColumn<bool>("usual");
        QTest::addColumn<bool>("least");
        QTest::newRow("closed") << 0.0 << false << false;
        QTest::newRow("narrower than the robot") << 1.0 << false << false;
        QTest::newRow("wide enough for who must") << 2.9 << false << true;
        QTest::newRow("a gate") << 5.0 << true << true;
    }
    void knowsThatNoWayLeads() {
        QFETCH(double, gap_m);
        QFETCH(bool, usual);
        QFETCH(bool, least);
        const RouteMap map = room(gap_m);
        QCOMPARE(map.route({0.0, 0.0}, {20.0, 0.0}, 6.0, 1.0).has_value(), usual);
        QCOMPARE(map.route({0.0, 0.0}, {20.0, 0.0}, 6.0, 1.0, Width::Least).has_value(), least);
        const ReachablePlaces reach = map.reach({0.0, 0.0}, 6.0);
        QVERIFY(reach.contains({6.0, -6.0}));
        QCOMPARE(reach.contains({20.0, 0.0}), usual);
        QVERIFY(reach.contains({5000.0, 0.0})); // Nothing is known of what is so far away.
    }

    /// Each look draws the door frame where the drift of that time has it; all of them together closed the door.
    void theDriftClosesNoDoor() {
        constexpr HeightBand band{1.6, 2.7};
        RouteMap map;
        map.passOver(passes_closer_m);
        for (int look = 0; look < 40; ++look)
            map.takeBand(wallWithDoor(look < 12 ? 1.2 : 0.0), band);
        const ReachablePlaces behind = map.reach({7.0, 0.0}, 2.4, Width::Least);
        QVERIFY(behind.contains({13.0, 0.0}));
        const auto way = map.route({7.0, 0.0}, {13.0, 0.0}, 2.4, 1.0, Width::Least);
        QVERIFY(way);
        for (const Vec2& point_m : *way)
            QVERIFY(std::abs(point_m.x() - 10.0) > 0.6 || std::abs(point_m.y()) < 1.5);
    }

    void aWallIsClosedThoughSomeBeamsSeemToPassIt() {
        constexpr HeightBand band{1.6, 2.7};
        RouteMap map;
        map.passOver(passes_closer_m);
        for (int look = 0; look < 40; ++look)
            map.takeBand(wallWithDoor(look < 12 ? 4.0 : 0.0), band);
        QVERIFY(map.hasRoom({10.0, 0.0}, 2.4, 0.4));
        QVERIFY(!map.hasRoom({10.0, 4.0}, 2.4, 0.4));
    }

    void whereItGetsNoFartherIsClosedWhateverBeamsSaid() {
        RouteMap map;
        map.passOver(passes_closer_m);
        for (int look = 0; look < 40; ++look)
            map.takeBand(wallWithDoor(0.0), {1.6, 2.7});
        QVERIFY(map.hasRoom({10.0, 0.0}, 2.4, 0.4));
        map.block({10.0, 0.0}, 2.4);
        QVERIFY(!map.hasRoom({10.0, 0.0}, 2.4, 0.4));
    }

    /// Over a shelf, everything around is in the way, and no map knows a direction.
    void goesBackTheWayItCame() {
        WayBack way;
        double now_s = 0.0;
        const auto fly = [&](const Vec2& here_m, double nearest_m) {
            way.note(Seconds(now_s += 0.2), here_m, nearest_m);
        };
        for (double x_m = 0.0; x_m <= 4.0; x_m += 0.1)
            fly({x_m, 0.0}, 4.2 - x_m);
        QVERIFY(!way.isPinned());
        for (int tick = 0; tick < 40; ++tick)
            fly({4.0, 0.0}, 0.2);
        QVERIFY(way.isPinned());
        way.begin();
        Vec2 here_m(4.0, 0.0);
        for (int tick = 0; tick < 100 && way.active(); ++tick) {
            const Vec2 aim_m = way.aim_m();
            QVERIFY(aim_m.x() < here_m.x());
            QVERIFY(std::abs(aim_m.y()) < 0.01);
            here_m += 0.1 * (aim_m - here_m).normalized();
            fly(here_m, 4.2 - here_m.x());
        }
        QVERIFY(!way.active());
        QVERIFY(here_m.x() > 2.0 && here_m.x() < 2.6); // There is room again.
    }

    /// There was room all around, and it stood for minutes.
    void goesBackAtLeastSoFar() {
        WayBack way;
        double now_s = 0.0;
        Vec2 here_m(0.0, 0.0);
        for (; here_m.x() < 6.0; here_m.x() += 0.1)
            way.note(Seconds(now_s += 0.2), here_m, 5.0);
        QVERIFY(!way.stands());
        while (now_s < 40.0)
            way.note(Seconds(now_s += 0.2), here_m, 5.0);
        QVERIFY(way.stands());
        QVERIFY(!way.isPinned());
        QVERIFY(way.begin(0.0, 3.0));
        for (int tick = 0; tick < 100 && way.active(); ++tick) {
            here_m += 0.1 * (way.aim_m() - here_m).normalized();
            way.note(Seconds(now_s += 0.2), here_m, 5.0);
        }
        QVERIFY2(here_m.x() > 2.8 && here_m.x() < 3.1, qPrintable(QString::number(here_m.x())));
    }

    void goesBackAllTheWay() {
        WayBack way;
        double now_s = 0.0;
        Vec2 here_m(0.0, 0.0);
        for (; here_m.x() < 6.0; here_m.x() += 0.1)
            way.note(Seconds(now_s += 0.2), here_m, 5.0);
        for (; here_m.y() < 6.0; here_m.y() += 0.1)
            way.note(Seconds(now_s += 0.2), here_m, 5.0);
        QVERIFY(way.beginWhole());
        for (int tick = 0; tick < 200 && way.active(); ++tick) {
            here_m += 0.1 * (way.aim_m() - here_m).normalized();
            way.note(Seconds(now_s += 0.2), here_m, 5.0);
        }
        QVERIFY2(here_m.norm() < 0.5, qPrintable(QString("%1 %2").arg(here_m.x()).arg(here_m.y())));
    }

    void comesNearerWhereItDoesNotGetOn() {
        Ways ways;
        double now_s = 100.0;
        Vec2 here_m(0.0, 0.0);
        const auto fly = [&](double seconds, double speed_m_s) {
            for (const double end_s = now_s + seconds; now_s < end_s; now_s += 0.2) {
                here_m.x() += 0.2 * speed_m_s;
                ways.noteProgress(Seconds(now_s), here_m);
            }
        };
        fly(10.0, 1.0);
        QVERIFY(!ways.isNarrow());
        fly(4.0, 0.0);
        QVERIFY(!ways.isNarrow());
        fly(3.0, 0.0);
        QVERIFY(ways.isNarrow());
        fly(4.0, 0.5);
        QVERIFY(ways.isNarrow()); // It has not got past that yet.
        fly(4.0, 0.5);
        QVERIFY(!ways.isNarrow());
        now_s += 60.0; // It was told to hover, which is no hesitation.
        fly(4.0, 0.0);
        QVERIFY(!ways.isNarrow());
    }

    void endsAWayBackOnWhichItDoesNotGetOn() {
        WayBack way;
        for (int tick = 0; tick < 20; ++tick)
            way.note(Seconds(0.2 * tick), {0.1 * tick, 0.0}, 0.2);
        way.begin();
        QVERIFY(way.active());
        for (int tick = 20; tick < 150; ++tick)
            way.note(Seconds(0.2 * tick), {2.0, 0.0}, 0.2);
        QVERIFY(!way.active());
    }

    void whatIsLowOrCeilingIsNotInTheWay() {
        RouteMap map;
        addWall(map, 5.0, -50.0, 50.0, 4.0);
        QVERIFY(map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 6.0));
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 5.0));
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        setFlatScan(senses, {0.0, 0.0}, 10.0, 7.0);
        map.take(senses, 6.6);
        QVERIFY(map.isStraightWayFree({0.0, 0.0}, {0.0, 8.0}, 6.0));
        map.take(senses, open_sky_m);
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {0.0, 8.0}, 6.0));
        map.clear();
        QVERIFY(map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 5.0));
    }

    void passesCloserOverThingsWhereItIsTold() {
        RouteMap map;
        addWall(map, 5.0, -50.0, 50.0, 5.0);
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 6.0));
        map.passOver(passes_closer_m);
        QVERIFY(map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 6.0));
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {10.0, 0.0}, 5.6));
    }

    void seesOverWhatIsLow_data() {
        QTest::addColumn<double>("top_m");
        QTest::addColumn<double>("to_x_m");
        QTest::addColumn<bool>("in_sight");
        QTest::newRow("a wall") << 8.0 << 7.0 << false;
        QTest::newRow("the wall itself") << 8.0 << 5.2 << true;
        QTest::newRow("a shelf") << 5.5 << 7.0 << true;
    }
    void seesOverWhatIsLow() {
        QFETCH(double, top_m);
        QFETCH(double, to_x_m);
        QFETCH(bool, in_sight);
        RouteMap map;
        addWall(map, 5.0, -8.0, 8.0, top_m);
        QCOMPARE(map.isInSight({3.0, 0.0}, {to_x_m, 0.0}, 6.0), in_sight);
    }

    void findsGroundBehindADoor_data() {
        QTest::addColumn<double>("door_m");
        QTest::addColumn<double>("ground_to_x_m");
        QTest::addColumn<bool>("found");
        QTest::newRow("a door and ground beyond it") << 3.0 << 18.0 << true;
        QTest::newRow("a door, and hardly any ground") << 3.0 << 13.0 << false;
        QTest::newRow("too narrow") << 1.0 << 18.0 << false;
        QTest::newRow("no door") << 0.0 << 18.0 << false;
    }
    void findsGroundBehindADoor() {
        QFETCH(double, door_m);
        QFETCH(double, ground_to_x_m);
        QFETCH(bool, found);
        RouteMap low = room(door_m); // as it is near the ground
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        senses.scan = PlacedScan{{1}, {}, {}, {}};
        for (double x_m = -9.0; x_m <= ground_to_x_m; x_m += 0.25)
            for (double y_m = -1.0; y_m <= 1.0; y_m += 0.25)
                if (std::abs(x_m - 10.0) > 0.5)
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        low.takeBand(*senses.scan, {1.6, 2.9});
        const ReachablePlaces high = room(0.0).reach({0.0, 0.0}, 6.0);
        const auto ground_m = low.groundBeyond_m({0.0, 0.0}, 2.4, 0.6, high, 4.0);
        QCOMPARE(ground_m.has_value(), found);
        QVERIFY(!found || (ground_m->x() > 12.0 && ground_m->x() < 13.5));
        QVERIFY(high.leadsNear({10.0, 0.0}, 2.5));
        QVERIFY(!high.leadsNear({13.0, 0.0}, 2.5));
    }

    void keepsToTheMiddleOfADoor() {
        const auto way = room(3.0).route({0.0, -6.0}, {20.0, -6.0}, 6.0, 1.0, Width::Least);
        QVERIFY(way);
        for (const Vec2& point_m : *way)
            QVERIFY(std::abs(point_m.x() - 10.0) > 0.4 || std::abs(point_m.y()) < 0.4);
    }

    /// A robot above a shelf gets off it, though it would not fly over one.
    void leavesWhatItIsAbove() {
        RouteMap map;
        for (double x_m = -1.0; x_m <= 1.0; x_m += 0.25)
            addWall(map, x_m, -6.0, 6.0, 5.2);
        QVERIFY(map.route({0.0, 0.0}, {10.0, 0.0}, 6.0, 1.0));
        QVERIFY(!map.isStraightWayFree({-8.0, 0.0}, {8.0, 0.0}, 6.0));
        QVERIFY(!map.route({0.0, 0.0}, {10.0, 0.0}, 5.0, 1.0)); // It would have to go through it.
    }

    void onlyAnEchoFromFartherAwayTakesBackAnEcho() {
        RouteMap map;
        map.take(heard("M0", 3.0), open_sky_m);
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {6.0, 0.0}, 6.0));
        map.take(heard("M0", 5.0), open_sky_m); // None: a smooth wall may have reflected it away.
        QVERIFY(!map.isStraightWayFree({0.0, 0.0}, {6.0, 0.0}, 6.0));
        map.take(heard("M0", 4.5), open_sky_m);
        QVERIFY(map.isStraightWayFree({0.0, 0.0}, {6.0, 0.0}, 6.0));
    }

    void aDetourLeadsAroundAndEndsWhereTheWayIsFree() {
        RouteMap map;
        addWall(map, 5.0, -8.0, 3.0);
        Detour detour;
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        QVERIFY(detour.start(map, senses, {10.0, 0.0}, Width::Usual));
        for (int tick = 0; tick < 300 && detour.active(); ++tick) {
            const Vec2 way_m = detour.aim_m(map, senses) - senses.position2_m();
            senses.base_in_map.position_m.head<2>() += way_m.normalized() * std::min(0.2, way_m.norm());
            senses.now += Seconds(0.2);
            QVERIFY(std::abs(senses.position2_m().x() - 5.0) > 0.7 || senses.position2_m().y() > 3.7);
        }
        QVERIFY(!detour.active());
        QVERIFY(map.isStraightWayFree(senses.position2_m(), {10.0, 0.0}, 6.0));
        QVERIFY(!detour.late(senses.now + Seconds(1e6)));
    }

    /// Something that no sensor shows holds the robot back.
    void learnsFromStandingStill() {
        RouteMap map;
        Detour detour;
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        addWall(map, 5.0, -8.0, 3.0);
        QVERIFY(detour.start(map, senses, {10.0, 0.0}, Width::Usual));
        const Vec2 first_m = detour.aim_m(map, senses);
        bool other_way = false;
        while (detour.active() && !detour.late(senses.now)) {
            senses.now += Seconds(0.2);
            other_way = other_way || (detour.aim_m(map, senses) - first_m).norm() > 1.5;
        }
        QVERIFY(other_way);
    }

    void knowsWhenItTakesTooLong() {
        RouteMap map;
        Detour detour;
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        QVERIFY(detour.start(map, senses, {10.0, 0.0}, Width::Usual));
        QVERIFY(!detour.late(senses.now + Seconds(200.0)));
        QVERIFY(detour.late(senses.now + Seconds(230.0)));
        detour.end();
        QVERIFY(!detour.late(senses.now + Seconds(230.0)));
    }
};

USAR_TEST(tst_Routes)

} // namespace tst_routes

#include "tst_routes.moc"
