// What was ordered of `warehouse`, `town` and `quarry`, for twenty seeds of each: properties of the worlds themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/sensors/rays.h"
#include "core/sim/world/world_generator.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/talker.h"
#include "tests/suite/suite.h"

namespace tst_made_worlds {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr int seeds = 20;
constexpr double steepest_rad = radians(15.0);

const World& made(const std::string& name, int seed) {
    static std::map<std::pair<std::string, int>, World> worlds;
    const auto [entry, is_new] = worlds.try_emplace({name, seed});
    if (is_new)
        entry->second = makeWorld(name, static_cast<std::uint64_t>(seed), USAR_SOURCE_DIR "/resources/worlds").value();
    return entry->second;
}

Vec3 randomDirection(Random& random) {
    return Vec3{gaussian(random, 1.0), gaussian(random, 1.0), gaussian(random, 1.0)}.normalized();
}

const Vec3& startOf(const World& world, const char* name) {
    return findStart(world, name)->position_m;
}

bool isTurnedLevel(const Box& box) {
    return box.center_in_map.roll_rad == 0.0 && box.center_in_map.pitch_rad == 0.0;
}
bool isUpright(const Box& box) {
    return isTurnedLevel(box) && box.center_in_map.yaw_rad == 0.0;
}
bool isWire(const Box& box) {
    return box.size_m.y() == wire_m && box.size_m.z() == wire_m;
}
bool isMast(const Plant& plant) {
    return plant.crown_radius_m == 0.0;
}

/// A point of the box, whose sides are at -1 and 1.
Vec3 pointOf(const Box& box, double x, double y, double z) {
    return box.center_in_map * Vec3(box.size_m.cwiseProduct(Vec3(x, y, z)) / 2.0);
}

bool contains(const Box& box, const Vec3& point_m) {
    const Vec3 off_m = inverse(box.center_in_map) * point_m;
    return (off_m.cwiseAbs() - box.size_m / 2.0).maxCoeff() <= 0.0;
}

/// How deep two upright boxes are in one another.
double depth_m(const Box& a, const Box& b) {
    const Vec3 apart_m = (a.center_in_map.position_m - b.center_in_map.position_m).cwiseAbs();
    return ((a.size_m + b.size_m) / 2.0 - apart_m).minCoeff();
}

/// Nine points of the lower or upper face, those at the border 1 cm inside of it.
std::vector<Vec3> pointsOfFace(const Box& box, double z) {
    std::vector<Vec3> points_m;
    for (const double x : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0})
            points_m.push_back(pointOf(box, x * (1.0 - 0.02 / box.size_m.x()), y * (1.0 - 0.02 / box.size_m.y()), z));
    return points_m;
}

bool isInGroundOrBox(const World& world, const Box& except, const Vec3& point_m) {
    return point_m.z() < world.terrain.height_m(point_m.head<2>()) ||
           std::ranges::any_of(world.boxes,
                               [&](const Box& other) { return &other != &except && contains(other, point_m); });
}

/// True if the ground or another box is right under a part of it.
bool isSupported(const World& world, const Box& box) {
    const Vec3 down_m = box.center_in_map.rotation() * Vec3(0.0, 0.0, -0.005);
    return std::ranges::any_of(pointsOfFace(box, -1.0),
                               [&](const Vec3& point_m) { return isInGroundOrBox(world, box, point_m + down_m); });
}

/// True if another box touches one of its ends or sides, as posts hold a shelf.
bool isHeld(const World& world, const Box& box) {
    const auto touches = [&](double x, double y) {
        const Vec3 out_m = box.center_in_map.rotation() * Vec3(0.005 * x, 0.005 * y, 0.0);
        const double inside = 1.0 - 0.02 / box.size_m.maxCoeff();
        for (const double along : {-inside, 0.0, inside})
            if (isInGroundOrBox(world, box, pointOf(box, x == 0.0 ? along : x, y == 0.0 ? along : y, 0.0) + out_m))
                return true;
        return false;
    };
    return touches(1.0, 0.0) || touches(-1.0, 0.0) || touches(0.0, 1.0) || touches(0.0, -1.0);
}

std::vector<Box> rampsOf(const World& warehouse) {
    std::vector<Box> ramps;
    std::ranges::copy_if(warehouse.boxes, std::back_inserter(ramps),
                         [](const Box& box) { return !isTurnedLevel(box) && box.size_m.y() > 1.0; });
    return ramps;
}

/// Ledges are the wide boxes that lie level; boulders are tilted.
std::vector<Box> ledgesOf(const World& quarry) {
    std::vector<Box> ledges;
    std::ranges::copy_if(quarry.boxes, std::back_inserter(ledges), isTurnedLevel);
    return ledges;
}

/// Where a ground robot gets to from one place on open ground that is nowhere steeper than `steepest_rad`.
class Reach {
public:
    Reach(const World& world, const Vec2& from_m) : extent_(world.terrain.extent()) {
        const RayCaster caster(world);
        std::queue<Eigen::Vector2i> border;
        border.push(cellOf(from_m));
        while (!border.empty()) {
            const Eigen::Vector2i cell = border.front();
            border.pop();
            for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const Vec2 next_m = pointAt(cell + way);
                if (extent_.contains(next_m) && !contains(next_m) && isGentle(world.terrain, pointAt(cell), next_m) &&
                    caster.surface_m(next_m) - world.terrain.height_m(next_m) < 1e-6) {
                    cells_.emplace(cellOf(next_m).x(), cellOf(next_m).y());
                    border.push(cell + way);
                }
            }
        }
    }

    bool contains(const Vec2& point_m) const { return cells_.contains({cellOf(point_m).x(), cellOf(point_m).y()}); }

private:
    static constexpr double step_m = 0.5;

    /// Looks at tenths of a meter, so that it does not step over a curb.
    static bool isGentle(const Terrain& terrain, const Vec2& from_m, const Vec2& to_m) {
        for (int part = 0; part < 5; ++part) {
            const Vec2 a_m = from_m + 0.2 * part * (to_m - from_m);
            const Vec2 b_m = a_m + 0.2 * (to_m - from_m);
            if (std::abs(terrain.height_m(b_m) - terrain.height_m(a_m)) > (b_m - a_m).norm() * std::tan(steepest_rad))
                return false;
        }
        return true;
    }

    Eigen::Vector2i cellOf(const Vec2& point_m) const {
        return ((point_m - extent_.min_m) / step_m).array().floor().cast<int>();
    }
    Vec2 pointAt(const Eigen::Vector2i& cell) const {
        return extent_.min_m + step_m * (cell.cast<double>() + Vec2::Constant(0.5));
    }

    Rectangle extent_;
    std::set<std::pair<int, int>> cells_;
};

} // namespace

class tst_MadeWorlds : public QObject {
    Q_OBJECT

private slots:
    void startsStandFree_data() { addWorlds(); }
    void startsStandFree() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = made(name.toStdString(), seed);
        const RayCaster caster(world);
        Random random = seeded(51, 1);
        QVERIFY(world.start_poses.size() >= 5);
        for (const NamedPose& start : world.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            QVERIFY2(std::abs(caster.cast(at_m, -Vec3::UnitZ(), 1.0) - 0.35) < 0.002, start.name.c_str());
            QVERIFY(!world.water || at_m.z() > world.water->surface_z_m + 0.5);
            for (int i = 0; i < 300; ++i) {
                Vec3 direction = randomDirection(random);
                direction.z() = std::abs(direction.z());
                QVERIFY2(caster.cast(at_m, direction, 1.0) == 1.0, start.name.c_str());
            }
            const bool upstairs = at_m.z() - world.terrain.height_m(at_m.head<2>()) > 1.0;
            const double roof_m = name == "warehouse" ? 9.0 - (upstairs ? mezzanine_m : 0.0) - 0.01 : 100.0;
            const double open_m = name == "warehouse" ? 1.4 : name == "town" ? 3.5 : 5.0;
            for (int i = 0; i < 3000; ++i) { // so many that a wire does not pass between them
                const Vec2 off_m{uniform(random, -open_m, open_m), uniform(random, -open_m, open_m)};
                if (off_m.norm() > open_m)
                    continue;
                const Vec2 near_m = at_m.head<2>() + off_m;
                const double ground_m = upstairs ? mezzanine_m : world.terrain.height_m(near_m);
                QVERIFY2(std::abs(caster.surface_m(near_m) - ground_m) < 1e-9, start.name.c_str());
                const double up_m = caster.cast({near_m.x(), near_m.y(), ground_m + 0.01}, Vec3::UnitZ(), 100.0);
                QVERIFY2(std::abs(up_m - roof_m) < 1e-6, start.name.c_str());
            }
        }
    }

    void nothingIsBuried_data() { addWorlds(); }
    void nothingIsBuried() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = made(name.toStdString(), seed);
        for (const Box& box : world.boxes) {
            QVERIFY(box.size_m.minCoeff() > 0.0);
            QVERIFY(std::ranges::any_of(pointsOfFace(box, 1.0), [&](const Vec3& point_m) {
                return point_m.z() > world.terrain.height_m(point_m.head<2>()) + 0.05;
            }));
        }
        for (const Plant& plant : world.plants) {
            const Vec3& base_m = plant.base_in_map_m;
            const double ground_m = world.terrain.height_m(base_m.head<2>());
            QVERIFY(base_m.z() <= ground_m && base_m.z() > ground_m - 1.5);
            QVERIFY(!world.water || ground_m > world.water->surface_z_m);
        }
    }

    void seedsMakeTheWorld_data() { addWorlds(); }
    void seedsMakeTheWorld() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = made(name.toStdString(), seed);
        QVERIFY(makeWorld(name.toStdString(), static_cast<std::uint64_t>(seed), {}) == world);
        const World& other = made(name.toStdString(), seed % seeds + 1);
        QVERIFY(world.boxes != other.boxes);
        QVERIFY(name == "warehouse" || world.terrain != other.terrain);
        QVERIFY(name == "warehouse" || world.plants != other.plants);
    }

    void theHallIsClosed_data() { addSeeds(); }
    void theHallIsClosed() {
        QFETCH(const int, seed);
        const World& hall = made("warehouse", seed);
        const RayCaster caster(hall);
        QVERIFY(caster.roofed());
        const double longest_m = Vec3(40.0, 30.0, 9.0).norm() + 1e-6;
        Random random = seeded(52, 1);
        for (int i = 0; i < 20000; ++i) {
            const Vec3 from_m{uniform(random, -20.0, 20.0), uniform(random, -15.0, 15.0), uniform(random, 0.0, 9.0)};
            QVERIFY(caster.cast(from_m, randomDirection(random), 1000.0) <= longest_m);
        }
        for (const NamedPose& start : hall.start_poses) {
            const Vec3& at_m = start.pose_in_map.position_m;
            QVERIFY(std::abs(at_m.z() + caster.cast(at_m, Vec3::UnitZ(), 1000.0) - 9.0) < 1e-9);
        }
    }

    void twoDoorwaysLeadToTheDock_data() { addSeeds(); }
    void twoDoorwaysLeadToTheDock() {
        QFETCH(const int, seed);
        const RayCaster caster(made("warehouse", seed));
        const auto isOpen = [&](double y_m, double z_m) {
            return caster.cast({9.5, y_m, z_m}, Vec3::UnitX(), 1.0) == 1.0;
        };
        int doors = 0;
        double open_m = 0.0;
        for (double y_m = -14.995; y_m < 15.0; y_m += 0.01) {
            doors += isOpen(y_m, 1.8) && !isOpen(y_m - 0.01, 1.8) ? 1 : 0;
            open_m += isOpen(y_m, 1.8) ? 0.01 : 0.0;
            QCOMPARE(isOpen(y_m, 0.05), isOpen(y_m, 1.8));
            QCOMPARE(isOpen(y_m, 3.95), isOpen(y_m, 1.8));
            QVERIFY(!isOpen(y_m, 4.05) && !isOpen(y_m, 8.95));
        }
        QCOMPARE(doors, 2);
        QVERIFY2(std::abs(open_m - 6.0) < 0.05, std::to_string(open_m).c_str());
    }

    void rampsLeadUpWithoutAStep_data() { addSeeds(); }
    void rampsLeadUpWithoutAStep() {
        QFETCH(const int, seed);
        const World& hall = made("warehouse", seed);
        const RayCaster caster(hall);
        const std::vector<Box> ramps = rampsOf(hall);
        QCOMPARE(ramps.size(), std::size_t{2});
        double highest_m = 0.0;
        for (const Box& ramp : ramps) {
            QVERIFY(std::abs(ramp.center_in_map.pitch_rad) < steepest_rad);
            const Vec2 foot_m = pointOf(ramp, -1.0, 0.0, 1.0).head<2>();
            const Vec2 top_m = pointOf(ramp, 1.0, 0.0, 1.0).head<2>();
            const Vec2 ahead = (top_m - foot_m).normalized();
            for (const double beside_m : {-0.9, 0.0, 0.9}) {
                const Vec2 side_m = beside_m * Vec2(-ahead.y(), ahead.x());
                double before_m = caster.surface_m(foot_m + side_m - ahead);
                QCOMPARE(before_m, 0.0);
                for (double way_m = -1.0; way_m < (top_m - foot_m).norm() + 1.5; way_m += 0.01) {
                    const Vec2 at_m = foot_m + side_m + way_m * ahead;
                    const double here_m = caster.surface_m(at_m);
                    QVERIFY2(here_m - before_m > -1e-6 && here_m - before_m < 0.01 * std::tan(steepest_rad) + 0.001,
                             qPrintable(QString("%1 m to %2 m").arg(before_m).arg(here_m)));
                    QVERIFY(caster.cast({at_m.x(), at_m.y(), here_m + 0.01}, Vec3::UnitZ(), 2.0) == 2.0);
                    before_m = here_m;
                }
                highest_m = std::max(highest_m, before_m);
                const double end_m = pointOf(ramp, 1.0, 0.0, 1.0).z();
                QVERIFY(std::abs(before_m - end_m) < 0.002);
            }
        }
        QCOMPARE(highest_m, mezzanine_m);
    }

    void aP2dxClimbsToTheMezzanine() {
        const World& hall = made("warehouse", 1);
        const auto simulation = simulationOf(hall);
        Talker talker(*simulation);
        const Vec3& at_m = startOf(hall, "RampFoot");
        talker.say("INIT {ClassName USARBot.P2DX} {Name R1} {Location " + std::to_string(at_m.x()) + "," +
                   std::to_string(-at_m.y()) + "," + std::to_string(-at_m.z()) + "} {Rotation 0,0,3.14159}");
        steps(*simulation, 10);
        talker.say("DRIVE {Left 5} {Right 5}"); // rad/s, that is 0.49 m/s
        steps(*simulation, 240);
        const Vec3 end_m = simulation->robots().at(0).base_in_map.position_m;
        QVERIFY2(end_m.x() < -13.5 && end_m.z() > mezzanine_m && end_m.z() < mezzanine_m + 0.5,
                 qPrintable(QString("%1 %2 %3").arg(end_m.x()).arg(end_m.y()).arg(end_m.z())));
    }

    void goodsStandOnSomethingAndInNothing_data() { addSeeds(); }
    void goodsStandOnSomethingAndInNothing() {
        QFETCH(const int, seed);
        const World& hall = made("warehouse", seed);
        int loads = 0;
        for (std::size_t i = 5; i < hall.boxes.size(); ++i) { // after four walls and the roof
            const Box& box = hall.boxes[i];
            const bool rail = box.size_m.minCoeff() < 0.07;
            const bool load = box.size_m.maxCoeff() < 1.5 && !rail;
            QVERIFY2(isSupported(hall, box) || (!load && isHeld(hall, box)), std::to_string(i).c_str());
            loads += load ? 1 : 0;
            for (std::size_t j = 5; j < i && isUpright(box); ++j)
                if (const Box& other = hall.boxes[j]; isUpright(other) && !(rail && other.size_m.minCoeff() < 0.07))
                    QVERIFY2(depth_m(box, other) < 1e-6, qPrintable(QString("%1 in %2").arg(i).arg(j)));
        }
        QVERIFY2(loads > 100, std::to_string(loads).c_str());
    }

    void looseThingsRestWhereTheyAre_data() { addSeeds(); }
    void looseThingsRestWhereTheyAre() {
        QFETCH(const int, seed);
        const World& hall = made("warehouse", seed);
        QVERIFY(hall.objects.size() >= 8);
        const auto physics = makePhysics(hall);
        std::set<std::string> names;
        std::vector<BodyId> bodies;
        for (const WorldObject& object : hall.objects) {
            names.insert(object.name);
            bodies.push_back(physics->add(object.body, object.body_in_map));
        }
        QCOMPARE(names.size(), hall.objects.size());
        for (const BodyId body : bodies)
            QVERIFY(!physics->isStuck(body));
        for (int step = 0; step < 500; ++step)
            physics->step(Seconds(0.004));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Vec3 moved_m = physics->state(bodies[i]).position_m - hall.objects[i].body_in_map.position_m;
            QVERIFY2(moved_m.norm() < 0.01, hall.objects[i].name.c_str());
        }
    }

    void wiresHangBetweenMastTops_data() { addSeeds(); }
    void wiresHangBetweenMastTops() {
        QFETCH(const int, seed);
        const World& town = made("town", seed);
        const RayCaster caster(town);
        std::vector<Box> pieces;
        std::ranges::copy_if(town.boxes, std::back_inserter(pieces), isWire);
        QVERIFY(pieces.size() % 4 == 0 && pieces.size() >= std::size_t{4 * 10});
        const auto isMastTop = [&](const Vec3& point_m) {
            return std::ranges::any_of(town.plants, [&](const Plant& plant) {
                const Vec3 top_m = plant.base_in_map_m + Vec3(0.0, 0.0, plant.trunk_height_m - 0.1);
                return isMast(plant) && (top_m - point_m).norm() < 0.002;
            });
        };
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Vec3 from_m = pointOf(pieces[i], -1.0, 0.0, 0.0);
            const Vec3 to_m = pointOf(pieces[i], 1.0, 0.0, 0.0);
            QVERIFY(i % 4 == 0 ? isMastTop(from_m) : (pointOf(pieces[i - 1], 1.0, 0.0, 0.0) - from_m).norm() < 0.002);
            QVERIFY(i % 4 != 3 || isMastTop(to_m));
            for (const double share : {0.1, 0.5, 0.9}) {
                const Vec3 at_m = from_m + share * (to_m - from_m);
                const double above_m = at_m.z() - town.terrain.height_m(at_m.head<2>());
                QVERIFY2(above_m > 6.0 && above_m < 9.0, std::to_string(above_m).c_str());
                const Vec3 over_m = at_m + Vec3(0.0, 0.0, 0.2);
                QVERIFY(std::abs(caster.cast(over_m, -Vec3::UnitZ(), 1.0) - 0.2 + wire_m / 2.0) < 0.001);
                const Vec3 beside_m = at_m - 0.2 * (pieces[i].center_in_map.rotation() * Vec3::UnitY());
                QVERIFY(std::abs(caster.cast(beside_m, pieces[i].center_in_map.rotation() * Vec3::UnitY(), 1.0) - 0.2 +
                                 wire_m / 2.0) < 1e-6);
            }
        }
    }

    void onlyMastsTouchTheWires_data() { addSeeds(); }
    void onlyMastsTouchTheWires() {
        QFETCH(const int, seed);
        World town = made("town", seed);
        std::vector<Box> pieces;
        std::ranges::copy_if(town.boxes, std::back_inserter(pieces), isWire);
        std::erase_if(town.boxes, isWire);
        const RayCaster caster(town);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            // At its ends a wire is fixed to its masts.
            const Vec3 from_m = pointOf(pieces[i], i % 4 == 0 ? -0.7 : -1.0, 0.0, 0.0);
            const Vec3 way_m = pointOf(pieces[i], i % 4 == 3 ? 0.7 : 1.0, 0.0, 0.0) - from_m;
            for (const Vec3& off_m : {Vec3(0.0, 0.0, 0.3), Vec3(0.0, 0.0, -0.3), Vec3(0.0, 0.0, 0.0)})
                QVERIFY(caster.cast(from_m + off_m, way_m.normalized(), way_m.norm()) == way_m.norm());
        }
    }

    void aSonarMeetsAWireOnlyByChance_data() {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("met_share"); // as robots-and-worlds.md, section 5, says
        QTest::newRow("1 m") << 1.0 << 1.0;
        QTest::newRow("2 m") << 2.0 << 0.68;
        QTest::newRow("3 m") << 3.0 << 0.53;
        QTest::newRow("4 m") << 4.0 << 0.41;
        QTest::newRow("4.9 m") << 4.9 << 0.35;
    }
    void aSonarMeetsAWireOnlyByChance() {
        QFETCH(const double, distance_m);
        QFETCH(const double, met_share);
        World world;
        world.boxes = {{{.position_m = {distance_m, 0.0, 0.0}}, {wire_m, 20.0, wire_m}}};
        const RayCaster caster(world);
        const auto physics = makePhysics(world);
        const BodyId eye = physics->add(BodyDescription{}, Pose{.position_m = {-5.0, 0.0, 0.0}});
        const WorldRays rays(caster, *physics, eye);
        const double half_rad = radians(7.5);
        std::vector<Vec3> directions{Vec3::UnitX()}; // as SonarSensor does
        for (const double off_axis_rad : {half_rad / 2.0, half_rad})
            for (int ray = 0; ray < 16; ++ray)
                directions.push_back(Eigen::AngleAxisd(pi * ray / 8.0, Vec3::UnitX()) *
                                     Vec3(std::cos(off_axis_rad), std::sin(off_axis_rad), 0.0));
        const double reach_m = distance_m * std::tan(half_rad);
        constexpr int places = 4000;
        int met = 0;
        for (int i = 0; i < places; ++i) {
            const double z_m = reach_m * (2.0 * (i + 0.5) / places - 1.0);
            met += rays.nearestEcho({0.0, 0.0, z_m}, directions, 5.0) < 5.0 ? 1 : 0;
        }
        QVERIFY2(std::abs(met / double{places} - met_share) < 0.005, std::to_string(met / double{places}).c_str());
    }

    void housesAreSolidUpToTheRidge_data() { addSeeds(); }
    void housesAreSolidUpToTheRidge() {
        QFETCH(const int, seed);
        const World& town = made("town", seed);
        std::set<int> heights_dm;
        int houses = 0;
        for (const Box& box : town.boxes) {
            QVERIFY(isWire(box) || isSupported(town, box));
            if (!isUpright(box) || box.size_m.minCoeff() < 4.0)
                continue;
            ++houses;
            const Vec3 top_m = box.center_in_map.position_m + Vec3(0.0, 0.0, box.size_m.z() / 2.0);
            heights_dm.insert(static_cast<int>(10.0 * box.size_m.z()));
            for (const Vec3& corner_m : pointsOfFace(box, -1.0))
                QVERIFY(corner_m.z() < town.terrain.height_m(corner_m.head<2>()));
            std::vector<Box> roof;
            std::ranges::copy_if(town.boxes, std::back_inserter(roof), [&](const Box& other) {
                const Vec2 off_m = other.center_in_map.position_m.head<2>() - top_m.head<2>();
                return !isTurnedLevel(other) && !isWire(other) && off_m.norm() < 3.0;
            });
            QVERIFY(roof.empty() || roof.size() == 2);
            for (const Box& side : roof)
                checkRoof(town, side, top_m.z());
        }
        QVERIFY2(houses >= 40 && houses <= 80, std::to_string(houses).c_str());
        QVERIFY2(heights_dm.size() > 15, std::to_string(heights_dm.size()).c_str());
    }

    void everyStartIsReachable_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("seed");
        for (const char* name : {"town", "quarry"})
            for (int seed = 1; seed <= seeds; ++seed)
                QTest::addRow("%s %d", name, seed) << QString(name) << seed;
    }
    void everyStartIsReachable() {
        QFETCH(const QString, name);
        QFETCH(const int, seed);
        const World& world = made(name.toStdString(), seed);
        const Reach reach(world, startOf(world, "PlayerStart").head<2>());
        for (const NamedPose& start : world.start_poses)
            QVERIFY2(reach.contains(start.pose_in_map.position_m.head<2>()), start.name.c_str());
    }

    void benchesAreAboveOneAnother_data() { addSeeds(); }
    void benchesAreAboveOneAnother() {
        QFETCH(const int, seed);
        const World& quarry = made("quarry", seed);
        const std::array starts{"PitFloor", "LowerBench", "PlayerStart", "UpperBench", "Rim"};
        for (std::size_t i = 1; i < starts.size(); ++i) {
            const double rise_m = startOf(quarry, starts[i]).z() - startOf(quarry, starts[i - 1]).z();
            QVERIFY2(rise_m > 4.3 && rise_m < 7.7, starts[i]);
        }
        int steep = 0;
        for (double x = -74.0; x < 74.0; x += 0.5)
            for (double y = -74.0; y < 74.0; y += 0.5) {
                const Vec2 rise{quarry.terrain.height_m({x + 0.1, y}) - quarry.terrain.height_m({x - 0.1, y}),
                                quarry.terrain.height_m({x, y + 0.1}) - quarry.terrain.height_m({x, y - 0.1})};
                steep += rise.norm() / 0.2 > std::tan(radians(60.0)) ? 1 : 0;
            }
        const double share = steep / (296.0 * 296.0);
        QVERIFY2(share > 0.02 && share < 0.15, std::to_string(share).c_str());
    }

    void thePondIsAllTheWater_data() { addSeeds(); }
    void thePondIsAllTheWater() {
        QFETCH(const int, seed);
        const World& quarry = made("quarry", seed);
        const double water_z_m = quarry.water.value().surface_z_m;
        QVERIFY(static_cast<double>(quarry.terrain.minimum_m()) < water_z_m - 2.5);
        double area_m2 = 0.0;
        for (double x = -74.75; x < 75.0; x += 0.5)
            for (double y = -74.75; y < 75.0; y += 0.5)
                if (quarry.terrain.height_m({x, y}) < water_z_m) {
                    area_m2 += 0.25;
                    QVERIFY(Vec2(x, y).norm() < 18.0);
                }
        QVERIFY2(area_m2 > 150.0 && area_m2 < 800.0, std::to_string(area_m2).c_str());
    }

    void ledgesJutOutOverLowerBenches_data() { addSeeds(); }
    void ledgesJutOutOverLowerBenches() {
        QFETCH(const int, seed);
        const World& quarry = made("quarry", seed);
        const RayCaster caster(quarry);
        const std::vector<Box> ledges = ledgesOf(quarry);
        QVERIFY2(ledges.size() >= 6, std::to_string(ledges.size()).c_str());
        for (const Box& ledge : ledges) {
            for (const double y : {-0.8, 0.0, 0.8}) {
                const Vec3 inner_m = pointOf(ledge, -0.95, y, -1.0);
                QVERIFY(inner_m.z() < quarry.terrain.height_m(inner_m.head<2>())); // it is held by the rock
            }
            const Vec3 under_m = pointOf(ledge, 0.8, 0.0, -1.0) - Vec3(0.0, 0.0, 0.01);
            const double free_m = caster.cast(under_m, -Vec3::UnitZ(), 20.0);
            QVERIFY2(free_m > 2.0 && free_m < 8.0, std::to_string(free_m).c_str());
            QVERIFY(std::abs(caster.surface_m(under_m.head<2>()) - pointOf(ledge, 0.0, 0.0, 1.0).z()) < 1e-6);
        }
    }

    void bouldersLieInTheGround_data() { addSeeds(); }
    void bouldersLieInTheGround() {
        QFETCH(const int, seed);
        const World& quarry = made("quarry", seed);
        int boulders = 0;
        for (const Box& box : quarry.boxes)
            if (!isTurnedLevel(box)) {
                ++boulders;
                const Vec3& at_m = box.center_in_map.position_m;
                QVERIFY(at_m.z() - box.size_m.minCoeff() / 2.0 < quarry.terrain.height_m(at_m.head<2>()));
            }
        QVERIFY2(boulders >= 60, std::to_string(boulders).c_str());
    }

private:
    /// A half of a roof rises from the eaves to the ridge and leaves no room under it.
    static void checkRoof(const World& town, const Box& side, double eaves_m) {
        const RayCaster caster(town);
        QVERIFY(std::abs(pointOf(side, -1.0, 0.0, 1.0).z() - eaves_m) < 0.002);
        const double ridge_m = pointOf(side, 1.0, 0.0, 1.0).z();
        QVERIFY(ridge_m > eaves_m + 1.0);
        for (const double along : {-0.8, -0.2, 0.3, 0.9}) {
            const Vec3 on_m = pointOf(side, along, 0.5, 1.0);
            if (const double seen_m = caster.surface_m(on_m.head<2>()); seen_m < on_m.z() + 0.001) // no tree above it
                QVERIFY(std::abs(seen_m - on_m.z()) < 0.001);
            for (double z_m = eaves_m + 0.01; z_m < on_m.z(); z_m += 0.1)
                QCOMPARE(caster.cast({on_m.x(), on_m.y(), z_m}, Vec3::UnitX(), 1.0), 0.0);
        }
    }

    static void addSeeds() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= seeds; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    static void addWorlds() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("seed");
        for (const char* name : {"warehouse", "town", "quarry"})
            for (int seed = 1; seed <= seeds; ++seed)
                QTest::addRow("%s %d", name, seed) << QString(name) << seed;
    }
};

USAR_TEST(tst_MadeWorlds)

} // namespace tst_made_worlds

#include "tst_made_worlds.moc"
