// What was ordered of the worlds beside `tall_test`: each property on the world itself, not on the code that makes it.
#include <algorithm>
#include <cmath>
#include <map>

#include <QObject>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world_generator.h"
#include "core/sim/world/world_reader.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_generated_worlds {

using usar::Pose;
using usar::Vec2;
using usar::Vec3;
using usar::doubles::pathOf;
using usar::doubles::readAll;
using usar::doubles::writeAll;
using usar::sim::RayCaster;
using usar::sim::World;

namespace {

const std::filesystem::path data = USAR_SOURCE_DIR "/resources/worlds";

const World& made(const std::string& name, int seed = 1) {
    static std::map<std::pair<std::string, int>, World> worlds;
    const auto [entry, is_new] = worlds.try_emplace({name, seed});
    if (is_new)
        entry->second = usar::sim::makeWorld(name, static_cast<std::uint64_t>(seed), data).value();
    return entry->second;
}

double shareBelow(const World& world, double z_m) {
    const auto& heights_m = world.terrain.heights_m();
    const auto below = std::count_if(heights_m.begin(), heights_m.end(),
                                     [&](float height_m) { return static_cast<double>(height_m) < z_m; });
    return static_cast<double>(below) / static_cast<double>(heights_m.size());
}

Vec3 anyDirection(usar::Random& random) {
    return Vec3{usar::gaussian(random, 1.0), usar::gaussian(random, 1.0), usar::gaussian(random, 1.0)}.normalized();
}

/// How far from a start pose nothing may stand.
double openAround_m(const std::string& world) {
    const std::map<std::string, double> open_m{
        {"vmac_room", 2.5}, {"spqr_soccer", 0.65}, {"warehouse", 1.4}, {"town", 3.5}, {"quarry", 5.0}};
    return open_m.contains(world) ? open_m.at(world) : 10.0;
}

} // namespace

class tst_GeneratedWorlds : public QObject {
    Q_OBJECT

private slots:
    void whatShipsReadsBackEqualToWhatItsSeedMakes_data() { addWorlds(); }
    void whatShipsReadsBackEqualToWhatItsSeedMakes() {
        QFETCH(QString, name);
        auto read = usar::sim::readWorld(USAR_BINARY_DIR "/share/worlds/" + name.toStdString());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        const World& world = made(name.toStdString());
        QCOMPARE(read->name, name.toStdString());
        QCOMPARE(read->boxes.size(), world.boxes.size());
        for (std::size_t i = 0; i < world.boxes.size(); ++i) {
            QVERIFY(read->boxes[i].center_in_map.isometry().isApprox(world.boxes[i].center_in_map.isometry(), 1e-12));
            read->boxes[i].center_in_map = world.boxes[i].center_in_map;
        }
        QCOMPARE(read->objects.size(), world.objects.size());
        for (std::size_t i = 0; i < world.objects.size(); ++i) {
            QVERIFY(read->objects[i].body_in_map.isometry().isApprox(world.objects[i].body_in_map.isometry(), 1e-12));
            read->objects[i].body_in_map = world.objects[i].body_in_map;
        }
        QVERIFY(*read == world);
    }

    void equalSeedsGiveEqualBytes_data() { addWorlds(); }
    void equalSeedsGiveEqualBytes() {
        QFETCH(QString, name);
        const QTemporaryDir a;
        const QTemporaryDir b;
        QVERIFY(usar::sim::generateWorld(name.toStdString(), 7, data, pathOf(a)));
        QVERIFY(usar::sim::generateWorld(name.toStdString(), 7, data, pathOf(b)));
        int files = 0;
        for (const auto& file : std::filesystem::directory_iterator(pathOf(a))) {
            QVERIFY(readAll(file.path()).size() > 1000);
            QVERIFY(readAll(file.path()) == readAll(pathOf(b) / file.path().filename()));
            ++files;
        }
        QVERIFY(files == 1 || files == 3);
    }

    void otherSeedsGiveOtherWorlds_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"vmac_room", "point_lookout", "volcano", "warehouse", "town", "quarry"})
            QTest::newRow(name) << QString(name);
    }
    void otherSeedsGiveOtherWorlds() {
        QFETCH(QString, name);
        QVERIFY(made(name.toStdString(), 1) != made(name.toStdString(), 2));
    }

    void startPosesAreFreeAndLevel_data() { addWorlds(); }
    void startPosesAreFreeAndLevel() {
        QFETCH(QString, name);
        const World& world = made(name.toStdString());
        const RayCaster caster(world);
        const auto physics = usar::sim::makePhysics(world);
        const usar::sim::BodyDescription air_robot{.parts = {{usar::sim::CylinderShape{0.5, 0.2}, {}}}};
        const auto body = physics->add(air_robot, world.start_poses.front().pose_in_map);
        QVERIFY(world.start_poses.size() >= 4);
        QCOMPARE(world.start_poses.front().name, std::string("PlayerStart"));
        for (const usar::sim::NamedPose& start : world.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            physics->place(body, start.pose_in_map);
            QVERIFY2(!physics->isStuck(body), start.name.c_str());
            const bool at_sea = world.water && world.terrain.height_m(at_m.head<2>()) < world.water->surface_z_m;
            const bool upstairs = name == "warehouse" && start.name == "Mezzanine";
            const auto ground_m = [&](const Vec2& point_m) {
                return upstairs ? usar::sim::mezzanine_m : world.terrain.height_m(point_m);
            };
            for (double bearing_rad = 0.0; bearing_rad < 6.2; bearing_rad += 0.1) {
                const Vec3 away(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
                for (const double radius_m : {0.5, 1.0, 2.0}) {
                    const Vec3 near_m = at_m + radius_m * away;
                    const double height_m = near_m.z() - ground_m(near_m.head<2>());
                    QVERIFY2(at_sea || std::abs(height_m - 0.35) < 0.05 * radius_m, start.name.c_str());
                }
                const double open_m = openAround_m(name.toStdString());
                for (double radius_m = 0.05; radius_m <= open_m; radius_m += 0.1) {
                    const Vec2 near_m = at_m.head<2>() + radius_m * away.head<2>();
                    QVERIFY2(std::abs(caster.surface_m(near_m) - ground_m(near_m)) < 1e-9, start.name.c_str());
                }
            }
            QVERIFY(caster.cast(at_m, Vec3::UnitZ(), 4.0) == 4.0);
        }
    }

    void theRoomIsClosed() {
        const World& room = made("vmac_room");
        const RayCaster caster(room);
        const usar::Rectangle extent{{-20.5, -13.0}, {20.5, 13.0}};
        QCOMPARE(room.terrain.extent(), extent);
        usar::Random random = usar::seeded(3, 0);
        const double longest_m = Vec3(40.0, 25.0, 6.0).norm() + 1e-6;
        for (int i = 0; i < 200000; ++i) {
            const Vec3 from_m{usar::uniform(random, -20.0, 20.0), usar::uniform(random, -12.5, 12.5),
                              usar::uniform(random, 0.0, 6.0)};
            QVERIFY(caster.cast(from_m, anyDirection(random), 1000.0) <= longest_m);
        }
        // Into the edges and corners, where walls meet.
        for (const double x : {-20.0, 0.3, 20.0})
            for (const double y : {-12.5, 0.3, 12.5})
                for (const double z : {0.0, 2.0, 6.0}) {
                    const Vec3 to = Vec3(x, y, z) - Vec3(1.0, 2.0, 3.0);
                    QVERIFY(caster.cast({1.0, 2.0, 3.0}, to.normalized(), 1000.0) <= to.norm() + 20.0);
                }
        QVERIFY(std::abs(caster.cast({1.0, 2.0, 3.0}, Vec3::UnitZ(), 1000.0) - 3.0) < 1e-9);
        QVERIFY(std::abs(caster.cast({1.0, 2.0, 3.0}, -Vec3::UnitZ(), 1000.0) - 3.0) < 1e-9);
        QVERIFY(std::abs(caster.cast({1.0, 2.0, 5.5}, Vec3::UnitX(), 1000.0) - 19.0) < 1e-9);
        QVERIFY(std::abs(caster.cast({1.0, 2.0, 5.5}, -Vec3::UnitY(), 1000.0) - 14.5) < 1e-9);
    }

    void underTheRoomsCeilingIsTheFloor() {
        const RayCaster caster(made("vmac_room"));
        QVERIFY(std::abs(caster.surface_m({1.0, 2.0})) < 1e-9);
        QVERIFY(caster.surface_m({12.0, 6.0}) > 5.99);                                           // a pillar
        QVERIFY(caster.surface_m({-14.0, -9.0}) > 2.3 && caster.surface_m({-14.0, -9.0}) < 4.5); // a shelf
    }

    void theRoomHasWhatItsSensorsFind() {
        const World& room = made("vmac_room");
        QCOMPARE(room.rfid_tags.size(), std::size_t{6});
        QCOMPARE(room.victims.size(), std::size_t{2});
        QVERIFY(!room.sounds.empty() && !room.gases.empty());
        const auto isInside = [](const Vec3& at_m) {
            return std::abs(at_m.x()) < 20.0 && std::abs(at_m.y()) < 12.5 && at_m.z() > 0.0 && at_m.z() < 6.0;
        };
        const RayCaster caster(room);
        for (const auto& tag : room.rfid_tags)
            QVERIFY2(isInside(tag.position_in_map_m), tag.memory.c_str());
        for (const auto& victim : room.victims)
            for (const auto& part : victim.parts) {
                QVERIFY(isInside(part.position_in_map_m));
                QVERIFY2(caster.cast(part.position_in_map_m, Vec3::UnitZ(), 1.0) > 0.0, victim.name.c_str());
            }
    }

    void theIslandLiesInTheSea_data() {
        QTest::addColumn<int>("seed");
        QTest::newRow("the seed that ships") << 1;
        QTest::newRow("seed 2") << 2;
    }
    void theIslandLiesInTheSea() {
        QFETCH(int, seed);
        const World& world = made("point_lookout", seed);
        const usar::Rectangle extent{{-512.0, -512.0}, {512.0, 512.0}};
        QCOMPARE(world.terrain.extent(), extent);
        QCOMPARE(world.terrain.step_m(), 1.0);
        QCOMPARE(world.water->surface_z_m, 0.0);
        const double sea = shareBelow(world, 0.0);
        QVERIFY2(sea >= 0.5 && sea < 0.85, std::to_string(sea).c_str());
        QVERIFY2(world.terrain.minimum_m() >= -25.0f && world.terrain.minimum_m() < -18.0f,
                 std::to_string(world.terrain.minimum_m()).c_str());
        QVERIFY2(world.terrain.maximum_m() > 15.0f, std::to_string(world.terrain.maximum_m()).c_str());
        for (double along_m = -512.0; along_m <= 512.0; along_m += 1.0)
            for (const double border_m : {-512.0, 512.0})
                QVERIFY(world.terrain.height_m({along_m, border_m}) < 0.0 &&
                        world.terrain.height_m({border_m, along_m}) < 0.0);
    }

    void theIslandHasCliffsAndBeaches() {
        const usar::sim::Terrain& terrain = made("point_lookout").terrain;
        int cliffs = 0;
        int beaches = 0;
        for (double y = -500.0; y <= 500.0; y += 2.0)
            for (double x = -500.0; x <= 490.0; x += 2.0) {
                const double here_m = terrain.height_m({x, y});
                const double beyond_m = terrain.height_m({x + 10.0, y});
                if ((here_m < 0.0) == (beyond_m < 0.0))
                    continue;
                ++(std::abs(beyond_m - here_m) > 10.0 ? cliffs : beaches);
            }
        QVERIFY2(cliffs > 100 && beaches > 100, (std::to_string(cliffs) + " " + std::to_string(beaches)).c_str());
    }

    void theIslandsTreesStandOnLand() {
        const World& world = made("point_lookout");
        QCOMPARE(world.plants.size(), std::size_t{3000});
        for (const usar::sim::Plant& tree : world.plants)
            QVERIFY(tree.trunk_height_m >= 3.0 && world.terrain.height_m(tree.base_in_map_m.head<2>()) >= 1.0);
    }

    void aSubmarineHasWaterBelowIt() {
        const World& world = made("point_lookout");
        int at_sea = 0;
        for (const usar::sim::NamedPose& start : world.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            if (world.terrain.height_m(at_m.head<2>()) > 0.0)
                continue;
            ++at_sea;
            QCOMPARE(at_m.z(), 1.0);
            for (double bearing_rad = 0.0; bearing_rad < 6.2; bearing_rad += 0.2) {
                const Vec2 near_m = at_m.head<2>() + 15.0 * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
                QVERIFY2(world.terrain.height_m(near_m) < -3.0, start.name.c_str());
            }
            QVERIFY2(world.terrain.height_m(at_m.head<2>()) < -8.0, start.name.c_str());
        }
        QCOMPARE(at_sea, 3);
    }

    void theBallRestsOnTheCarpet() {
        const World& field = made("spqr_soccer");
        QCOMPARE(field.objects.size(), std::size_t{1});
        const usar::sim::WorldObject& ball = field.objects[0];
        QCOMPARE(ball.body.mass_kg, 0.06);
        QCOMPARE(ball.body.restitution, 0.6);
        QVERIFY(ball.body.rolling_friction_m > 0.0);
        const auto* const shape = std::get_if<usar::sim::SphereShape>(&ball.body.parts.at(0).shape);
        QVERIFY(shape);
        QCOMPARE(shape->radius_m, 0.043);
        const auto physics = usar::sim::makePhysics(field);
        const auto body = physics->add(ball.body, ball.body_in_map);
        for (int step = 0; step < 1000; ++step)
            physics->step(usar::Seconds(0.004));
        const Vec3 moved_m = physics->state(body).position_m - ball.body_in_map.position_m;
        QVERIFY2(moved_m.norm() < 0.002, std::to_string(moved_m.norm()).c_str());
        QVERIFY(std::abs(RayCaster(field).surface_m({0.0, 0.0}) + usar::sim::ball_radius_m -
                         ball.body_in_map.position_m.z()) < 1e-9);
    }

    void theBoardsKeepTheBall() {
        const RayCaster caster(made("spqr_soccer"));
        for (double bearing_rad = 0.0; bearing_rad < 6.28; bearing_rad += 0.001) {
            const Vec3 away(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
            const double reach_m = caster.cast({0.0, 0.0, usar::sim::ball_radius_m}, away, 100.0);
            const Vec3 end_m = reach_m * away;
            QVERIFY(std::abs(end_m.x()) <= 3.3 + 1e-9 && std::abs(end_m.y()) <= 2.0 + 1e-9);
            const bool in_goal = std::abs(end_m.x()) > 3.0 + 1e-9;
            QVERIFY(!in_goal || std::abs(end_m.y()) <= 0.4 + 1e-9);
            const double above_m = caster.cast({0.0, 0.0, 0.2}, away, 100.0);
            QVERIFY(in_goal || above_m > reach_m); // a robot sees over the boards
        }
    }

    void theVolcanoIsTheMeasuredOne() {
        const auto source = usar::sim::readElevationCsv(data / "volcano" / "volcano_10m.csv");
        QVERIFY(source);
        QCOMPARE(source->rows, std::size_t{87});
        QCOMPARE(source->columns, std::size_t{61});
        const World& world = made("volcano");
        const usar::Rectangle extent{{-430.0, -300.0}, {430.0, 300.0}};
        QCOMPARE(world.terrain.extent(), extent);
        QCOMPARE(world.terrain.step_m(), 0.5);
        double sum_m = 0.0;
        double largest_m = 0.0;
        for (std::size_t row = 0; row < source->rows; ++row)
            for (std::size_t column = 0; column < source->columns; ++column) {
                const Vec2 at_m(10.0 * static_cast<double>(row) - 430.0, 10.0 * static_cast<double>(column) - 300.0);
                const double error_m = world.terrain.height_m(at_m) - source->at(row, column);
                sum_m += error_m;
                largest_m = std::max(largest_m, std::abs(error_m));
            }
        QVERIFY2(largest_m <= usar::sim::volcano_noise_m, std::to_string(largest_m).c_str());
        const double mean_m = sum_m / static_cast<double>(source->rows * source->columns);
        QVERIFY2(std::abs(mean_m) < 0.02, std::to_string(mean_m).c_str());
        QCOMPARE(source->at(0, 0), 100.0);
        QCOMPARE(source->at(86, 60), 94.0);
    }

    void theVolcanoIsRoughBetweenItsPosts() {
        const usar::sim::Terrain& terrain = made("volcano").terrain;
        double bends_m = 0.0;
        int count = 0;
        for (double x = -400.0; x < 400.0; x += 7.0)
            for (double y = -280.0; y < 280.0; y += 7.0, ++count)
                bends_m += std::abs(terrain.height_m({x - 1.0, y}) + terrain.height_m({x + 1.0, y}) -
                                    2.0 * terrain.height_m({x, y}));
        const double mean_m = bends_m / count;
        QVERIFY2(mean_m > 0.01 && mean_m < 0.2, std::to_string(mean_m).c_str());
    }

    void aTableOfHeightsIsReadByRows() {
        const QTemporaryDir folder;
        writeAll(pathOf(folder) / "a.csv", "1,2,3,4,5\n6,7,8,9,10\n-1,0.5,0,0,0\n0,0,0,0,1e2\n");
        const auto table = usar::sim::readElevationCsv(pathOf(folder) / "a.csv");
        QVERIFY(table);
        QCOMPARE(table->rows, std::size_t{4});
        QCOMPARE(table->columns, std::size_t{5});
        QCOMPARE(table->at(1, 2), 8.0);
        QCOMPARE(table->at(2, 1), 0.5);
        QCOMPARE(table->at(3, 4), 100.0);
    }

    void refusesABrokenTable_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("line");
        QTest::newRow("a word") << QString("1,2,3,4\n1,2,x,4\n1,2,3,4\n1,2,3,4\n") << QString(":2");
        QTest::newRow("a gap") << QString("1,2,3,4\n1,2,3,4\n1,,3,4\n1,2,3,4\n") << QString(":3");
        QTest::newRow("infinity") << QString("inf,2,3,4\n") << QString(":1");
        QTest::newRow("a short line") << QString("1,2,3,4\n1,2,3\n1,2,3,4\n1,2,3,4\n") << QString(":2");
        QTest::newRow("an empty line") << QString("1,2,3,4\n\n1,2,3,4\n1,2,3,4\n") << QString(":2");
        QTest::newRow("too few lines") << QString("1,2,3,4\n1,2,3,4\n1,2,3,4\n") << QString("");
        QTest::newRow("too few heights a line") << QString("1,2,3\n1,2,3\n1,2,3\n1,2,3\n") << QString("");
        QTest::newRow("nothing") << QString("") << QString("");
    }
    void refusesABrokenTable() {
        QFETCH(QString, text);
        QFETCH(QString, line);
        const QTemporaryDir folder;
        const std::filesystem::path file = pathOf(folder) / "a.csv";
        writeAll(file, text.toStdString());
        const auto table = usar::sim::readElevationCsv(file);
        QVERIFY(!table);
        QCOMPARE(table.error().where, file.string() + line.toStdString());
        QVERIFY(!table.error().mend.empty());
    }

    void aMissingTableIsNamed() {
        const QTemporaryDir folder;
        const auto world = usar::sim::makeWorld("volcano", 1, pathOf(folder));
        QVERIFY(!world);
        QCOMPARE(world.error().where, (pathOf(folder) / "volcano" / "volcano_10m.csv").string());
    }

private:
    static void addWorlds() {
        QTest::addColumn<QString>("name");
        for (const std::string& name : usar::sim::generatedWorldNames())
            QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
};

USAR_TEST(tst_GeneratedWorlds)

} // namespace tst_generated_worlds

#include "tst_generated_worlds.moc"
