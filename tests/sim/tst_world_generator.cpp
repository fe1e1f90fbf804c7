#include "core/sim/world/world_generator.h"

#include <algorithm>
#include <map>

#include <QObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world_reader.h"
#include "core/sim/worlds/fractal_noise.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_world_generator {

using usar::Vec2;
using usar::Vec3;
using usar::doubles::pathOf;
using usar::doubles::readAll;
using usar::sim::Plant;
using usar::sim::World;

namespace {

const std::filesystem::path data = USAR_SOURCE_DIR "/resources/worlds";

const World& tallTest(int seed) {
    static std::map<int, World> made;
    const auto [entry, is_new] = made.try_emplace(seed);
    if (is_new)
        entry->second = usar::sim::makeTallTest(static_cast<std::uint64_t>(seed));
    return entry->second;
}

bool isTree(const Plant& plant) {
    return plant.trunk_height_m > 0.0;
}

Vec2 footOf(const Plant& plant) {
    return plant.base_in_map_m.head<2>();
}

/// Share of a 1 m grid over the rectangle +-half where a body of 0.9 m radius at 6 m above ground touches something.
double blockedShare(const World& world, const Vec2& half_m) {
    const usar::sim::RayCaster caster(world);
    int blocked = 0;
    int all = 0;
    for (double x = -half_m.x(); x <= half_m.x(); x += 1.0)
        for (double y = -half_m.y(); y <= half_m.y(); y += 1.0, ++all) {
            const Vec3 at_m{x, y, world.terrain.height_m({x, y}) + 6.0};
            for (int i = 0; i < 16; ++i) {
                const double angle_rad = usar::pi * i / 8.0;
                if (caster.cast(at_m, {std::cos(angle_rad), std::sin(angle_rad), 0.0}, 0.9) < 0.9) {
                    ++blocked;
                    break;
                }
            }
        }
    return static_cast<double>(blocked) / all;
}

} // namespace

class tst_WorldGenerator : public QObject {
    Q_OBJECT

private slots:
    void equalSeedsGiveEqualBytes() {
        const QTemporaryDir a;
        const QTemporaryDir b;
        QVERIFY(usar::sim::generateWorld("tall_test", 7, data, pathOf(a)));
        QVERIFY(usar::sim::generateWorld("tall_test", 7, data, pathOf(b)));
        for (const char* name : {"world.sdf", "height.png", "plants.csv"}) {
            const std::string bytes = readAll(pathOf(a) / name);
            QVERIFY2(bytes.size() > 1000, name);
            QVERIFY2(bytes == readAll(pathOf(b) / name), name);
        }
    }

    void otherSeedsGiveOtherWorlds() {
        QVERIFY(tallTest(1).terrain.heights_m() != tallTest(2).terrain.heights_m());
        QVERIFY(tallTest(1).plants != tallTest(2).plants);
    }

    void whatIsWrittenReadsBackEqual() {
        const QTemporaryDir folder;
        QVERIFY(usar::sim::generateWorld("tall_test", 1, data, pathOf(folder)));
        const auto read = usar::sim::readWorld(pathOf(folder));
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        const World& made = tallTest(1);
        QCOMPARE(read->name, made.name);
        QVERIFY(read->terrain.heights_m() == made.terrain.heights_m());
        QCOMPARE(read->terrain.extent(), made.terrain.extent());
        QVERIFY(read->plants == made.plants);
        QVERIFY(read->water == made.water);
        QVERIFY(read->start_poses == made.start_poses);
        QCOMPARE(read->boxes.size(), made.boxes.size());
        for (std::size_t i = 0; i < made.boxes.size(); ++i) {
            QVERIFY(read->boxes[i].center_in_map.isometry().isApprox(made.boxes[i].center_in_map.isometry(), 1e-12));
            QVERIFY(read->boxes[i].size_m == made.boxes[i].size_m);
        }
    }

    void refusesAnUnknownNameAndSaysTheKnown() {
        const QTemporaryDir folder;
        const auto made = usar::sim::generateWorld("atlantis", 1, data, pathOf(folder));
        QVERIFY(!made);
        QCOMPARE(made.error().where, std::string("atlantis"));
        QVERIFY(made.error().mend.find("tall_test") != std::string::npos);
    }

    void saysWhenTheFolderCannotBeMade() {
        const QTemporaryDir folder;
        usar::doubles::writeAll(pathOf(folder) / "file", "in the way");
        const auto made = usar::sim::generateWorld("tall_test", 1, data, pathOf(folder) / "file" / "world");
        QVERIFY(!made);
        QVERIFY(!made.error().mend.empty());
    }

    void holdsWhatWasOrdered_data() { addSeeds(); }
    void holdsWhatWasOrdered() {
        QFETCH(int, seed);
        const World& world = tallTest(seed);
        QCOMPARE(world.terrain.columns(), std::size_t{1025});
        QCOMPARE(world.terrain.rows(), std::size_t{1025});
        const usar::Rectangle extent{{-128.0, -128.0}, {128.0, 128.0}};
        QCOMPARE(world.terrain.extent(), extent);
        QVERIFY(world.terrain.maximum_m() - world.terrain.minimum_m() > 15.0f);
        QCOMPARE(std::count_if(world.plants.begin(), world.plants.end(), isTree), 2000);
        QCOMPARE(world.plants.size(), std::size_t{2200});
        QCOMPARE(world.boxes.size(), std::size_t{3});
        QVERIFY(world.water);
        const auto wet = std::count_if(world.terrain.heights_m().begin(), world.terrain.heights_m().end(),
                                       [&](float z_m) { return static_cast<double>(z_m) < world.water->surface_z_m; });
        const double wet_share = static_cast<double>(wet) / static_cast<double>(world.terrain.heights_m().size());
        QVERIFY2(wet_share > 0.002 && wet_share < 0.1, std::to_string(wet_share).c_str());
    }

    void startPosesAreLevelOpenAndDry_data() { addSeeds(); }
    void startPosesAreLevelOpenAndDry() {
        QFETCH(int, seed);
        const World& world = tallTest(seed);
        const usar::sim::RayCaster caster(world);
        QCOMPARE(world.start_poses.size(), std::size_t{4});
        QCOMPARE(world.start_poses.front().name, std::string("PlayerStart"));
        for (const usar::sim::NamedPose& start : world.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            QVERIFY(std::abs(at_m.z() - 0.35 - world.terrain.height_m(at_m.head<2>())) < 1e-3);
            QVERIFY2(at_m.z() > world.water->surface_z_m + 1.0, start.name.c_str());
            for (double bearing_rad = 0.0; bearing_rad < 6.2; bearing_rad += 0.2) {
                const Vec2 away{std::cos(bearing_rad), std::sin(bearing_rad)};
                QVERIFY(std::abs(world.terrain.height_m(at_m.head<2>() + 2.0 * away) + 0.35 - at_m.z()) < 0.01);
                for (const double radius_m : {1.0, 4.0, 7.0, 10.0}) {
                    const Vec2 near_m = at_m.head<2>() + radius_m * away;
                    QVERIFY(std::abs(caster.surface_m(near_m) - world.terrain.height_m(near_m)) < 1e-9);
                }
            }
        }
    }

    void treesKeepTheirDistanceAndStandOnDryGround_data() { addSeeds(); }
    void treesKeepTheirDistanceAndStandOnDryGround() {
        QFETCH(int, seed);
        const World& world = tallTest(seed);
        std::vector<Plant> trees;
        std::copy_if(world.plants.begin(), world.plants.end(), std::back_inserter(trees), isTree);
        std::sort(trees.begin(), trees.end(),
                  [](const Plant& a, const Plant& b) { return footOf(a).x() < footOf(b).x(); });
        for (auto tree = trees.begin(); tree != trees.end(); ++tree) {
            const double ground_m = world.terrain.height_m(footOf(*tree));
            QVERIFY(tree->base_in_map_m.z() <= ground_m && tree->base_in_map_m.z() > ground_m - 1.0);
            QVERIFY(ground_m > world.water->surface_z_m);
            QVERIFY(tree->trunk_radius_m >= 0.12 && tree->trunk_radius_m <= 0.32);
            QVERIFY(tree->trunk_height_m >= 3.0 && tree->trunk_height_m <= 7.0);
            QVERIFY(tree->crown_radius_m >= 1.0 && tree->crown_radius_m <= 2.5);
            for (auto other = tree + 1; other != trees.end() && footOf(*other).x() - footOf(*tree).x() < 2.5; ++other)
                QVERIFY((footOf(*other) - footOf(*tree)).norm() >= 2.5);
        }
    }

    void leavesRoomToFlyNearThePlayerStart_data() { addSeeds(); }
    void leavesRoomToFlyNearThePlayerStart() {
        QFETCH(int, seed);
        const double near = blockedShare(tallTest(seed), {30.0, 20.0});
        const double everywhere = blockedShare(tallTest(seed), {100.0, 100.0});
        QVERIFY2(near > 0.05 && near < 0.2, std::to_string(near).c_str());
        QVERIFY2(everywhere > 0.15 && everywhere < 0.45, std::to_string(everywhere).c_str());
    }

    void noiseIsSmoothAndBounded() {
        const usar::sim::FractalNoise noise{.seed = 5};
        usar::Random random = usar::seeded(5, 0);
        double lowest_m = 0.0;
        double highest_m = 0.0;
        for (int i = 0; i < 20000; ++i) {
            const Vec2 at_m{usar::uniform(random, -500.0, 500.0), usar::uniform(random, -500.0, 500.0)};
            const double here_m = noise.at(at_m);
            QVERIFY(std::abs(here_m) < 16.0);
            // Each octave adds at most 2 * 1.875 * amplitude / wavelength of slope along an axis.
            QVERIFY(std::abs(noise.at(at_m + Vec2{0.01, 0.0}) - here_m) < 0.01 * 6.0 * 0.375 + 1e-6);
            lowest_m = std::min(lowest_m, here_m);
            highest_m = std::max(highest_m, here_m);
        }
        QVERIFY(lowest_m < -6.0 && highest_m > 6.0);
    }

private:
    static void addSeeds() {
        QTest::addColumn<int>("seed");
        QTest::newRow("the seed that ships") << 1;
        QTest::newRow("seed 2") << 2;
        QTest::newRow("seed 3") << 3;
    }
};

USAR_TEST(tst_WorldGenerator)

} // namespace tst_world_generator

#include "tst_world_generator.moc"
