#include "core/sim/world/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr std::array<std::string_view, 7> part_names{"Head", "Arm", "Hand", "Chest", "Pelvis", "Leg", "Foot"};

/// Half size of the axis-aligned bounding box of a box in any attitude.
Vec3 reach_m(const Box& box) {
    return box.center_in_map.rotation().toRotationMatrix().cwiseAbs() * (box.size_m / 2.0);
}

} // namespace

Rectangle extentOf(const World& world) {
    if (!world.terrain.empty() || world.boxes.empty())
        return world.terrain.extent();
    Rectangle extent{Vec2::Constant(1e300), Vec2::Constant(-1e300)};
    for (const Box& box : world.boxes) {
        const Vec2 center_m = box.center_in_map.position_m.head<2>();
        extent.min_m = extent.min_m.cwiseMin(center_m - reach_m(box).head<2>());
        extent.max_m = extent.max_m.cwiseMax(center_m + reach_m(box).head<2>());
    }
    return extent;
}

double dryAbove_m(const World& world) {
    if (world.water)
        return world.water->surface_z_m;
    double lowest_m = world.terrain.empty() ? std::numeric_limits<double>::infinity() : world.terrain.minimum_m();
    for (const Box& box : world.boxes)
        lowest_m = std::min(lowest_m, box.center_in_map.position_m.z() - reach_m(box).z());
    return std::isfinite(lowest_m) ? lowest_m : 0.0;
}

bool isNear(const World& world, const Vec3& point_in_map_m) {
    constexpr double margin_m = 1000.0;
    const Rectangle extent = extentOf(world);
    Eigen::AlignedBox3d box(Vec3(extent.min_m.x(), extent.min_m.y(), world.terrain.minimum_m()),
                            Vec3(extent.max_m.x(), extent.max_m.y(), world.terrain.maximum_m()));
    for (const Box& solid : world.boxes)
        box.extend(solid.center_in_map.position_m - reach_m(solid))
            .extend(solid.center_in_map.position_m + reach_m(solid));
    return point_in_map_m.allFinite() && box.exteriorDistance(point_in_map_m) <= margin_m;
}

const Pose* findStart(const World& world, std::string_view name) {
    const auto found =
        std::ranges::find_if(world.start_poses, [&](const NamedPose& start) { return sameWord(start.name, name); });
    return found == world.start_poses.end() ? nullptr : &found->pose_in_map;
}

std::string_view nameOf(VictimPartKind kind) {
    return part_names.at(static_cast<std::size_t>(kind));
}

std::optional<VictimPartKind> victimPartKind(std::string_view name) {
    const auto found = std::ranges::find(part_names, name);
    if (found == part_names.end())
        return std::nullopt;
    return static_cast<VictimPartKind>(found - part_names.begin());
}

} // namespace usar::sim
