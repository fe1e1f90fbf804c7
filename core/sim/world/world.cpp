#include "core/sim/world/world.h"

#include <algorithm>
#include <array>

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
