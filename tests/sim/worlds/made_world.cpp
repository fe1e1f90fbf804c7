#include "tests/sim/worlds/made_world.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include <QTest>

#include "core/sim/world/world_generator.h"

namespace usar::sim {

namespace {

bool contains(const Box& box, const Vec3& point_m) {
    const Vec3 off_m = inverse(box.center_in_map) * point_m;
    return (off_m.cwiseAbs() - box.size_m / 2.0).maxCoeff() <= 0.0;
}

bool isInGroundOrBox(const World& world, const Box& except, const Vec3& point_m) {
    return point_m.z() < world.terrain.height_m(point_m.head<2>()) ||
           std::ranges::any_of(world.boxes,
                               [&](const Box& other) { return &other != &except && contains(other, point_m); });
}

} // namespace

const World& madeWorld(const std::string& name, int seed) {
    static std::map<std::pair<std::string, int>, World> worlds;
    const auto [entry, is_new] = worlds.try_emplace({name, seed});
    if (is_new)
        entry->second = makeWorld(name, static_cast<std::uint64_t>(seed), USAR_SOURCE_DIR "/resources/worlds").value();
    return entry->second;
}

void addSeeds() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= made_seeds; ++seed)
        QTest::addRow("seed %d", seed) << seed;
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

Vec3 pointOf(const Box& box, double x, double y, double z) {
    return box.center_in_map * Vec3(box.size_m.cwiseProduct(Vec3(x, y, z)) / 2.0);
}

std::vector<Vec3> pointsOfFace(const Box& box, double z) {
    std::vector<Vec3> points_m;
    for (const double x : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0})
            points_m.push_back(pointOf(box, x * (1.0 - 0.02 / box.size_m.x()), y * (1.0 - 0.02 / box.size_m.y()), z));
    return points_m;
}

bool isSupported(const World& world, const Box& box) {
    const Vec3 down_m = box.center_in_map.rotation() * Vec3(0.0, 0.0, -0.005);
    return std::ranges::any_of(pointsOfFace(box, -1.0),
                               [&](const Vec3& point_m) { return isInGroundOrBox(world, box, point_m + down_m); });
}

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

} // namespace usar::sim
