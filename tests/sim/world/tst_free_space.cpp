#include <QTest>

#include <cmath>

#include <QElapsedTimer>

#include "core/sim/world/free_space.h"
#include "core/sim/worlds/building.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_free_space {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr double ceiling_m = 6.0;

/// A house without a door on flat ground: walls around `inner`, and a ceiling at this height.
World houseOf(const Rectangle& inner, double underside_m = ceiling_m, double wall_m = 0.5) {
    World world = flatWorld();
    const Vec2 low = inner.min_m - Vec2::Constant(wall_m);
    const Vec2 high = inner.max_m + Vec2::Constant(wall_m);
    const double top_m = underside_m + 0.5;
    world.boxes = {block({low.x(), low.y(), -0.5}, {inner.min_m.x(), high.y(), top_m}),
                   block({inner.max_m.x(), low.y(), -0.5}, {high.x(), high.y(), top_m}),
                   block({low.x(), low.y(), -0.5}, {high.x(), inner.min_m.y(), top_m}),
                   block({low.x(), inner.max_m.y(), -0.5}, {high.x(), high.y(), top_m}),
                   block({low.x(), low.y(), underside_m}, {high.x(), high.y(), top_m})};
    return world;
}

const Rectangle room{{-10, -5}, {10, 5}};

/// Two rooms beside each other with a wall along the y axis, which has a gap of this width in the middle; 0: no gap.
World twoRooms(double gap_m) {
    World world = houseOf(room);
    if (!(gap_m > 0.0)) {
        world.boxes.push_back(block({-0.1, -5, 0}, {0.1, 5, ceiling_m}));
        return world;
    }
    world.boxes.push_back(block({-0.1, -5, 0}, {0.1, -gap_m / 2, ceiling_m}));
    world.boxes.push_back(block({-0.1, gap_m / 2, 0}, {0.1, 5, ceiling_m}));
    return world;
}

World turned(World world, double yaw_rad) {
    const Eigen::AngleAxisd turn(yaw_rad, Vec3::UnitZ());
    for (Box& box : world.boxes) {
        box.center_in_map.position_m = turn * box.center_in_map.position_m;
        box.center_in_map.yaw_rad += yaw_rad;
    }
    return world;
}

FlightLimits from(double x, double y) {
    return {.start_in_map_m = {x, y, 0.35}, .scan_altitude_m = 6.0, .maximum_height_m = 19.0};
}

/// Share of the rectangle's points, 0.25 m apart, of which this is true.
double share_pct(const ReachMap& reach, const Rectangle& area, Reach wanted) {
    int all = 0, so = 0;
    for (double x = area.min_m.x() + 0.125; x < area.max_m.x(); x += 0.25)
        for (double y = area.min_m.y() + 0.125; y < area.max_m.y(); y += 0.25) {
            ++all;
            so += reach({x, y}) == wanted;
        }
    return 100.0 * so / all;
}

} // namespace

class tst_FreeSpace : public QObject {
    Q_OBJECT
private slots:
    void openGroundIsReachedUpToTheWorldsEdge() {
        for (const World& world : {flatWorld(), slopeWorld(radians(60.0))}) {
            const ReachMap reach = reachFrom(world, from(0, 0), {{-50, -50}, {50, 50}});
            QVERIFY(reach);
            QCOMPARE(share_pct(reach, {{-32, -32}, {32, 32}}, Reach::Scanned), 100.0);
            QCOMPARE(share_pct(reach, {{33, -50}, {50, 50}}, Reach::OutsideWorld), 100.0);
        }
    }

    void aCliffIsNoWall() {
        World world = groundOf([](const Vec2& at_m) { return at_m.x() > 5.0 ? 80.0 : 0.0; });
        world.boxes = {block({-30, -30, 0}, {-29, -29, 1})}; // Without any box nothing is filled.
        QCOMPARE(
            share_pct(reachFrom(world, from(0, 0), {{-20, -20}, {20, 20}}), {{-20, -20}, {20, 20}}, Reach::Scanned),
            100.0);
    }

    void aClosedRoomEndsAtItsWalls_data() {
        QTest::addColumn<double>("wall_m");
        QTest::addColumn<double>("yaw_rad");
        QTest::newRow("thick walls") << 0.5 << 0.0;
        QTest::newRow("thin walls") << 0.02 << 0.0;
        QTest::newRow("diagonal") << 0.1 << pi / 4;
        QTest::newRow("askew") << 0.05 << 0.3;
    }

    void aClosedRoomEndsAtItsWalls() {
        QFETCH(double, wall_m);
        QFETCH(double, yaw_rad);
        const World world = turned(houseOf(room, ceiling_m, wall_m), yaw_rad);
        const ReachMap reach = reachFrom(world, from(0, 0), {{-30, -30}, {30, 30}});
        const Eigen::Rotation2Dd turn(yaw_rad);
        int outside = 0, missed = 0;
        for (double x = -29.9; x < 30.0; x += 0.2)
            for (double y = -29.9; y < 30.0; y += 0.2) {
                const bool inside = std::abs(x) < 10.0 && std::abs(y) < 5.0;
                // Right behind a thin wall a column may be counted that has its center before it.
                const bool far_outside = std::abs(x) > 10.0 + wall_m + 0.25 || std::abs(y) > 5.0 + wall_m + 0.25;
                const Vec2 at_m = turn * Vec2(x, y);
                outside += far_outside && world.terrain.extent().contains(at_m) && reach(at_m) != Reach::ShutOff;
                missed += inside && reach(at_m) != Reach::Scanned;
            }
        QCOMPARE(outside, 0);
        QVERIFY2(missed <= 50 * 100 / 100, qPrintable(QString::number(missed))); // 1 % of the room, at its walls
    }

    void aRoomIsReachedThroughADoorThatIsWideEnough_data() {
        QTest::addColumn<double>("gap_m");
        QTest::addColumn<bool>("through");
        QTest::newRow("no door") << 0.0 << false;
        QTest::newRow("a slit") << 0.3 << false;
        QTest::newRow("narrower than the robot") << 0.9 << false;
        QTest::newRow("a door") << 1.6 << true;
        QTest::newRow("a gate") << 4.0 << true;
    }

    void aRoomIsReachedThroughADoorThatIsWideEnough() {
        QFETCH(double, gap_m);
        QFETCH(bool, through);
        const ReachMap reach = reachFrom(twoRooms(gap_m), from(-5, 0), room);
        QVERIFY(share_pct(reach, {{-10, -5}, {-0.2, 5}}, Reach::Scanned) > 99.0);
        const double beyond_pct = share_pct(reach, {{0.2, -5}, {10, 5}}, Reach::Scanned);
        QVERIFY2(through ? beyond_pct > 99.0 : beyond_pct < 3.0, qPrintable(QString::number(beyond_pct)));
    }

    void aLowCeilingIsFlownUnder_data() {
        QTest::addColumn<double>("underside_m");
        QTest::addColumn<bool>("fits");
        QTest::newRow("lower than the scan altitude") << 3.0 << true;
        QTest::newRow("just high enough") << 1.5 << true;
        QTest::newRow("too low to fly") << 1.1 << false;
    }

    void aLowCeilingIsFlownUnder() {
        QFETCH(double, underside_m);
        QFETCH(bool, fits);
        // A hall with a low part behind the middle.
        World world = houseOf(room);
        world.boxes.push_back(block({0, -5, underside_m}, {10, 5, ceiling_m}));
        const ReachMap reach = reachFrom(world, from(-5, 0), room);
        const double pct = share_pct(reach, {{2, -5}, {10, 5}}, Reach::Scanned);
        QVERIFY2(fits ? pct > 99.0 : pct == 0.0, qPrintable(QString::number(pct)));
    }

    void aWallUnderTheSkyIsFlownOverIfTheRobotClimbs_data() {
        QTest::addColumn<double>("maximum_height_m");
        QTest::addColumn<bool>("over");
        QTest::newRow("it climbs") << 19.0 << true;
        QTest::newRow("it never climbs") << 6.0 << false;
    }

    void aWallUnderTheSkyIsFlownOverIfTheRobotClimbs() {
        QFETCH(double, maximum_height_m);
        QFETCH(bool, over);
        World world = flatWorld();
        world.boxes = {block({5, -40, -1}, {5.5, 40, 10})};
        FlightLimits flight = from(0, 0);
        flight.maximum_height_m = maximum_height_m;
        const ReachMap reach = reachFrom(world, flight, {{-20, -20}, {20, 20}});
        QCOMPARE(reach({15, 0}), over ? Reach::Scanned : Reach::ShutOff);
        QCOMPARE(reach({-15, 0}), Reach::Scanned);
    }

    void aHouseIsSeenFromAboveButNotFromWithin() {
        const World world = houseOf(room);
        QCOMPARE(reachFrom(world, from(20, 20), {{-20, -20}, {20, 20}})({0, 0}), Reach::Scanned); // its roof
        QCOMPARE(reachFrom(world, from(0, 0), {{-20, -20}, {20, 20}})({20, 20}), Reach::ShutOff);
    }

    void plantsAreNoObstacle() {
        World world = flatWorld();
        world.boxes = {block({-30, -30, 0}, {-29, -29, 1})};
        for (double y = -32.0; y <= 32.0; y += 0.5)
            world.plants.push_back(
                {.base_in_map_m = {5, y, 0}, .trunk_radius_m = 0.3, .trunk_height_m = 25.0, .crown_radius_m = 2.0});
        QCOMPARE(reachFrom(world, from(0, 0), {{-20, -20}, {20, 20}})({15, 0}), Reach::Scanned);
    }

    void deepWaterIsFlownOverButNotScanned_data() {
        QTest::addColumn<double>("depth_m");
        QTest::addColumn<Reach>("reach");
        QTest::newRow("a pond, whose bottom is seen") << 4.5 << Reach::Scanned;
        QTest::newRow("deeper than the scan altitude") << 5.5 << Reach::OverWater;
        QTest::newRow("the sea") << 30.0 << Reach::OverWater;
    }

    void deepWaterIsFlownOverButNotScanned() {
        QFETCH(double, depth_m);
        QFETCH(Reach, reach);
        World world = groundOf([&](const Vec2& at_m) { return at_m.x() > 5.0 && at_m.x() < 15.0 ? -depth_m : 1.0; });
        world.water = Water{};
        const ReachMap map = reachFrom(world, from(0, 0), {{-20, -20}, {20, 20}});
        QCOMPARE(map({10, 0}), reach);
        QCOMPARE(map({0, 0}), Reach::Scanned);
        QCOMPARE(map({20, 0}), Reach::Scanned); // behind it
    }

    void aStartWithoutAirTellsNothing() {
        QVERIFY(!reachFrom(houseOf(room, 0.9), from(0, 0), room));
        QVERIFY(!reachFrom(flatWorld(), from(100, 0), room));  // outside the world
        QVERIFY(reachFrom(houseOf(room), from(9.8, 0), room)); // closer to the wall than the body is wide
    }

    void theRoomOfTheThesisIsReachedButForItsWalls() {
        const World world = makeVmacRoom(1);
        const FlightLimits flight{.start_in_map_m = findStart(world, "PlayerStart")->position_m,
                                  .scan_altitude_m = 3.0};
        const ReachMap reach = reachFrom(world, flight, {{-30, -30}, {30, 30}});
        const double pct = share_pct(reach, {{-20, -12.5}, {20, 12.5}}, Reach::Scanned);
        QVERIFY2(pct > 98.0, qPrintable(QString::number(pct)));
        QCOMPARE(reach({0, 15}), Reach::OutsideWorld);
    }

    void aSquareKilometerTakesSeconds() {
        const int posts = 101;
        World world;
        world.terrain = Terrain(posts, posts, 10.0, {-500, -500}, std::vector<float>(posts * posts, 0.0f));
        for (int i = 0; i < 100; ++i)
            world.boxes.push_back(block({-450.0 + 9.0 * i, -300, -1}, {-446.0 + 9.0 * i, 300, 15}));
        QElapsedTimer timer;
        timer.start();
        const ReachMap reach = reachFrom(world, from(-480, 0), {{-500, -500}, {500, 500}});
        qInfo("a square kilometer in %lld ms", timer.elapsed());
        QCOMPARE(reach({480, 480}), Reach::Scanned);
        QVERIFY2(timer.elapsed() < 30'000, qPrintable(QString::number(timer.elapsed())));
    }
};

USAR_TEST(tst_FreeSpace)

} // namespace tst_free_space

#include "tst_free_space.moc"
