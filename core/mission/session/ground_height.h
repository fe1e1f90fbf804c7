// How high the ground is where something is put into the world, from the best source that knows.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "core/mapping/height_probe.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// What there is to know of the ground, the best source first. Lengths are in meters of the map frame. Plain references
/// to what others own: made for one question.
struct GroundSources {
    /// The true ground of a simulator of our own; empty, or nullopt for a point, where it is not known.
    std::function<std::optional<double>(const Vec2& point_in_map_m)> terrain_m{};
    const mapping::HeightTiles* tiles = nullptr; ///< what a robot has scanned; nullptr: no robot
    double cell_size_m = 0.25;                   ///< of the tiles
    std::span<const protocol::StartPose> start_poses{};
};

/// Height of the ground at a point of the map frame: the terrain's, else the scanned one, else that of the nearest
/// start pose, and 0 where nothing is known at all.
double groundHeight_m(const GroundSources& sources, const Vec2& at_m);

} // namespace usar::mission
