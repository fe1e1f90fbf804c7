// The parts that generated worlds are made of, as properties over many random places and seeds.
#include <algorithm>
#include <cmath>
#include <set>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/worlds/building.h"
#include "core/sim/worlds/fractal_noise.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/suite/suite.h"

namespace tst_world_building {

using namespace usar;
using namespace usar::sim;

namespace {

Terrain rough(std::uint64_t seed) {
    const FractalNoise noise{.seed = seed, .octaves = 4, .wavelength_m = 9.0, .amplitude_m = 3.0};
    return terrainOf({.columns = 41, .rows = 31, .step_m = 0.5}, [&](const Vec2& at_m) { return noise.at(at_m); });
}

Vec2 randomIn(Random& random, double half_m) {
    return {uniform(random, -half_m, half_m), uniform(random, -half_m, half_m)};
}

bool isWhole(double value, double step) {
    return std::abs(value / step - std::round(value / step)) < 1e-6;
}

} // namespace

class tst_WorldBuilding : public QObject {
    Q_OBJECT

private slots:
    void lengthsAreWholeMillimeters() {
        QCOMPARE(wholeMillimetres(1.23449), 1.234);
        QCOMPARE(wholeMillimetres(-1.23451), -1.235);
        Random random = seeded(31, 1);
        for (int i = 0; i < 1000; ++i) {
            const double value_m = between(random, -2.5, 7.25);
            QVERIFY(value_m >= -2.5 && value_m <= 7.25);
            QVERIFY(isWhole(value_m, 0.001));
        }
    }

    void aGroundIsSampledAtItsPosts() {
        const Terrain ground = terrainOf({.columns = 5, .rows = 3, .step_m = 2.0, .steps_per_m = 4.0},
                                         [](const Vec2& at_m) { return 0.3 * at_m.x() - 1.1 * at_m.y(); });
        QCOMPARE(ground.extent(), (Rectangle{{-4.0, -2.0}, {4.0, 2.0}}));
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 5; ++column) {
                const Vec2 at_m(2.0 * static_cast<double>(column) - 4.0, 2.0 * static_cast<double>(row) - 2.0);
                const auto height_m = static_cast<double>(ground.post_m(column, row));
                QVERIFY(isWhole(height_m, 0.25));
                QVERIFY(std::abs(height_m - (0.3 * at_m.x() - 1.1 * at_m.y())) <= 0.125 + 1e-6);
            }
    }

    void nothingStandsAboveTheGroundAroundIt() {
        const Terrain ground = rough(4);
        Random random = seeded(32, 1);
        for (int i = 0; i < 300; ++i) {
            const Vec2 at_m = randomIn(random, 6.0);
            const double radius_m = uniform(random, 0.0, 1.0);
            const double lowest_m = lowestGround_m(ground, at_m, radius_m);
            QVERIFY(isWhole(lowest_m, 0.001));
            QVERIFY(lowest_m <= ground.height_m(at_m));
            for (const Vec2& side_m : ringAround(at_m, radius_m))
                QVERIFY(lowest_m <= ground.height_m(side_m));
        }
    }

    void theGroundUnderARectangleIsItsLowestAndHighest() {
        const Terrain ground = terrainOf({.columns = 41, .rows = 41, .step_m = 0.5},
                                         [](const Vec2& at_m) { return 0.5 * at_m.x() + 0.25 * at_m.y(); });
        const GroundRange level = groundUnder(ground, {1.0, 2.0}, {4.0, 2.0}, 0.0);
        QVERIFY(std::abs(level.lowest_m - (1.0 - 1.0 - 0.25)) < 1e-6);
        QVERIFY(std::abs(level.highest_m - (1.0 + 1.0 + 0.25)) < 1e-6);
        const GroundRange turned = groundUnder(ground, {1.0, 2.0}, {4.0, 2.0}, pi / 2.0);
        QVERIFY(std::abs(turned.lowest_m - (1.0 - 0.5 - 0.5)) < 1e-6);
        QVERIFY(std::abs(turned.highest_m - (1.0 + 0.5 + 0.5)) < 1e-6);
    }

    void beamsAndSlabsRunFromPointToPoint() {
        Random random = seeded(36, 1);
        for (int i = 0; i < 300; ++i) {
            const Vec3 from_m{between(random, -9.0, 9.0), between(random, -9.0, 9.0), between(random, -4.0, 4.0)};
            const Vec3 to_m{between(random, -9.0, 9.0), between(random, -9.0, 9.0), between(random, -4.0, 4.0)};
            const auto end = [](const Box& box, double x, double z) -> Vec3 {
                return box.center_in_map * Vec3(x * box.size_m.x() / 2.0, 0.0, z * box.size_m.z() / 2.0);
            };
            const Box bar = beam(from_m, to_m, 0.5, 0.2);
            QVERIFY((end(bar, -1.0, 0.0) - from_m).norm() < 1e-3 && (end(bar, 1.0, 0.0) - to_m).norm() < 1e-3);
            const Box ramp = slab(from_m, to_m, 0.5, 0.2);
            QVERIFY((end(ramp, -1.0, 1.0) - from_m).norm() < 1e-3 && (end(ramp, 1.0, 1.0) - to_m).norm() < 1e-3);
            QVERIFY(ramp.center_in_map.position_m.z() < bar.center_in_map.position_m.z());
            for (const Box& box : {bar, ramp}) {
                QVERIFY(box.size_m.y() == 0.5 && box.size_m.z() == 0.2);
                QVERIFY(std::abs((box.center_in_map.rotation() * Vec3::UnitY()).z()) < 1e-12); // its width lies level
            }
        }
    }

    void ringsAreEvenlySpaced() {
        const auto ring_m = ringAround({1.0, -2.0}, 3.0);
        QVERIFY((ring_m[0] - Vec2(4.0, -2.0)).norm() < 1e-12);
        QVERIFY((ring_m[2] - Vec2(1.0, 1.0)).norm() < 1e-12);
        for (std::size_t i = 0; i < ring_m.size(); ++i) {
            QVERIFY(std::abs((ring_m[i] - Vec2(1.0, -2.0)).norm() - 3.0) < 1e-12);
            const double apart_m = (ring_m[(i + 1) % ring_m.size()] - ring_m[i]).norm();
            QVERIFY(std::abs(apart_m - 6.0 * std::sin(pi / 8.0)) < 1e-12);
        }
    }

    void treesAreOfTheOrderedSizes() {
        const Terrain ground = rough(5);
        Random random = seeded(33, 1);
        int cones = 0;
        for (int i = 0; i < 500; ++i) {
            const Vec2 at_m = randomIn(random, 7.0);
            const Plant tree = makeTree(random, ground, at_m);
            QVERIFY(tree.base_in_map_m.head<2>() == at_m);
            QVERIFY(tree.base_in_map_m.z() <= ground.height_m(at_m));
            QVERIFY(tree.trunk_radius_m >= 0.12 && tree.trunk_radius_m <= 0.32);
            QVERIFY(tree.trunk_height_m >= 3.0 && tree.trunk_height_m <= 7.0);
            QVERIFY(tree.crown_radius_m >= 1.0 && tree.crown_radius_m <= 2.5);
            const bool cone = tree.crown == CrownShape::Cone;
            cones += cone ? 1 : 0;
            QVERIFY(cone ? tree.crown_height_m >= 3.0 && tree.crown_height_m <= 6.0 : tree.crown_height_m == 0.0);
        }
        QVERIFY(cones > 200 && cones < 300);
    }

    void plantsAreScatteredUntilThereAreEnough_data() {
        QTest::addColumn<int>("wanted");
        QTest::addColumn<int>("most_tries");
        QTest::addColumn<int>("planted");
        QTest::addColumn<int>("tries");
        QTest::newRow("none") << 0 << 100 << 0 << 0;
        QTest::newRow("every third try fits") << 5 << 100 << 5 << 15;
        QTest::newRow("too few tries") << 5 << 10 << 3 << 10;
        QTest::newRow("no try") << 5 << 0 << 0 << 0;
    }
    void plantsAreScatteredUntilThereAreEnough() {
        QFETCH(const int, wanted);
        QFETCH(const int, most_tries);
        QFETCH(const int, planted);
        QFETCH(const int, tries);
        World world;
        Spacing trunks(50.0);
        int asked = 0;
        scatter(world, trunks, wanted, most_tries, [&]() -> std::optional<Plant> {
            ++asked;
            if (asked % 3 != 0)
                return std::nullopt;
            return Plant{.base_in_map_m = {static_cast<double>(asked), 0.0, 0.0}};
        });
        QCOMPARE(asked, tries);
        QCOMPARE(world.plants.size(), static_cast<std::size_t>(planted));
        for (const Plant& plant : world.plants)
            QVERIFY(!trunks.isClear(plant.base_in_map_m.head<2>(), 0.5));
        QVERIFY(trunks.isClear({-20.0, 0.0}, 5.0));
    }

    void spacingAgreesWithTryingAllPoints_data() {
        QTest::addColumn<double>("half_m");
        QTest::newRow("one bucket") << 1.5;
        QTest::newRow("a few buckets") << 9.0;
        QTest::newRow("many buckets") << 70.0;
    }
    void spacingAgreesWithTryingAllPoints() {
        QFETCH(const double, half_m);
        Random random = seeded(34, 1);
        Spacing spacing(half_m);
        std::vector<Vec2> points_m;
        int clear = 0;
        for (int i = 0; i < 600; ++i) {
            const Vec2 at_m = randomIn(random, half_m);
            const double distance_m = uniform(random, 0.0, half_m / 8.0);
            const bool expected = std::ranges::all_of(
                points_m, [&](const Vec2& point_m) { return (point_m - at_m).norm() >= distance_m; });
            QCOMPARE(spacing.isClear(at_m, distance_m), expected);
            clear += expected ? 1 : 0;
            if (i % 3 == 0) {
                spacing.add(at_m);
                points_m.push_back(at_m);
            }
        }
        QVERIFY(clear > 20 && clear < 600);
    }

    void theBestPlaceIsTheHighestOfTheGrid() {
        const auto score = [](const Vec2& at_m) -> std::optional<double> {
            if (at_m.x() > 5.0)
                return std::nullopt;
            return -(at_m - Vec2(7.0, -3.0)).norm();
        };
        QVERIFY((bestOnGrid(10.0, 1.0, score) - Vec2(5.0, -3.0)).norm() < 1e-9);
        QVERIFY(bestOnGrid(10.0, 1.0, [](const Vec2&) { return std::optional<double>(); }) == Vec2::Zero());
        // Of several that are equally good, the first one.
        QVERIFY(bestOnGrid(2.0, 1.0, [](const Vec2&) { return std::optional(1.0); }) == Vec2(-2.0, -2.0));
    }

    void startsStandAboveTheGround() {
        World world;
        world.terrain = rough(6);
        addStarts(world, {{"A", {0.1, 0.2}, 0.12345}, {"B", {-3.0, 4.0}, -pi}});
        QCOMPARE(world.start_poses.size(), std::size_t{2});
        for (const NamedPose& start : world.start_poses) {
            const Pose& pose = start.pose_in_map;
            const double above_m = pose.position_m.z() - world.terrain.height_m(pose.position_m.head<2>());
            QVERIFY(std::abs(above_m - spawn_height_m) <= 0.0005 + 1e-9);
            QVERIFY(isWhole(pose.yaw_rad, 0.001));
        }
        const std::vector<StartPlace> places{{"A", {0.0, 0.0}, 0.0}, {"B", {10.0, 0.0}, 0.0}};
        QVERIFY(isFarFrom(places, {5.0, 0.0}, 4.9));
        QVERIFY(!isFarFrom(places, {5.0, 0.0}, 5.0));
        QVERIFY(isFarFrom({}, {5.0, 0.0}, 1e9));
        QCOMPARE(yawToward({1.0, 1.0}, {1.0, 5.0}), pi / 2.0);
    }

    void noiseIsBoundedSmoothAndItsSeeds() {
        const FractalNoise noise{.seed = 77, .octaves = 6, .wavelength_m = 20.0, .amplitude_m = 5.0};
        FractalNoise other = noise;
        other.seed = 78;
        Random random = seeded(35, 1);
        double highest_m = 0.0;
        int different = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec2 at_m = randomIn(random, 500.0);
            const double value_m = noise.at(at_m);
            QCOMPARE(noise.at(at_m), value_m);
            QVERIFY(std::abs(value_m) < 10.0);
            QVERIFY(std::abs(noise.at(at_m + Vec2(1e-6, -1e-6)) - value_m) < 1e-3);
            highest_m = std::max(highest_m, std::abs(value_m));
            different += other.at(at_m) != value_m ? 1 : 0;
        }
        QVERIFY(highest_m > 2.5); // it uses its range
        QVERIFY(different > 1990);
    }

    void aSmoothStepRisesFromZeroToOne() {
        QCOMPARE(smoothStep(2.0, 4.0, 1.9), 0.0);
        QCOMPARE(smoothStep(2.0, 4.0, 3.0), 0.5);
        QCOMPARE(smoothStep(2.0, 4.0, 4.1), 1.0);
        double before = 0.0;
        for (double value = 2.0; value <= 4.0; value += 0.01) {
            const double step = smoothStep(2.0, 4.0, value);
            QVERIFY(step >= before && step - before < 0.01);
            QVERIFY(std::abs(step + smoothStep(2.0, 4.0, 6.0 - value) - 1.0) < 1e-9);
            before = step;
        }
    }

    void everySeedMakesASoundRoom() {
        std::set<double> tops_m;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const World room = makeVmacRoom(seed);
            const Rectangle extent = room.terrain.extent();
            for (const Box& box : room.boxes) {
                QVERIFY2(box.size_m.minCoeff() > 0.0, qPrintable(QString("seed %1").arg(seed)));
                const Vec2 middle_m = box.center_in_map.position_m.head<2>();
                QVERIFY(extent.contains(middle_m - box.size_m.head<2>() / 2.0 + Vec2::Constant(1e-9)));
                QVERIFY(extent.contains(middle_m + box.size_m.head<2>() / 2.0 - Vec2::Constant(1e-9)));
                QVERIFY(box.center_in_map.position_m.z() - box.size_m.z() / 2.0 <= 6.0);
            }
            for (const NamedPose& start : room.start_poses)
                QVERIFY(std::ranges::none_of(room.boxes, [&](const Box& box) {
                    const Vec3 off_m = start.pose_in_map.position_m - box.center_in_map.position_m;
                    return (off_m.cwiseAbs() - box.size_m / 2.0).maxCoeff() < 0.3;
                }));
            tops_m.insert(room.boxes[11].size_m.z()); // a side of the first shelf, after walls, ceiling and pillars
            QVERIFY(makeVmacRoom(seed) == room);
        }
        QVERIFY(tops_m.size() > 10);
    }

    void theFieldNeedsNoSeed() {
        const World field = makeSpqrSoccer(1);
        for (std::uint64_t seed = 2; seed <= 5; ++seed)
            QVERIFY(makeSpqrSoccer(seed) == field);
        for (const Box& box : field.boxes) // the field is the same from both ends
            QVERIFY(std::ranges::any_of(field.boxes, [&](const Box& other) {
                const Vec3 mirrored_m = box.center_in_map.position_m.cwiseProduct(Vec3(-1.0, -1.0, 1.0));
                return (other.center_in_map.position_m - mirrored_m).norm() < 1e-9 &&
                       (other.size_m - box.size_m).norm() < 1e-9;
            }));
    }
};

USAR_TEST(tst_WorldBuilding)

} // namespace tst_world_building

#include "tst_world_building.moc"
