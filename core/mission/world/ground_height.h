// Height of the ground at a place in the world, from the best source that knows it.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// The sources of ground height, best first. Lengths are in meters in the map frame. It only refers to data that others
/// own, so create it for a single query.
struct GroundSources {
    /// Height of the embedded simulator's terrain; empty without one, and nullopt for a point of unknown height.
    std::function<std::optional<double>(const Vec2& point_in_map_m)> terrain_m{};
    const mapping::HeightTiles* tiles = nullptr; ///< ground scanned by a robot; nullptr: no robot
    double cell_size_m = 0.25;                   ///< size of a cell of `tiles`
    std::span<const protocol::StartPose> start_poses{};
};

/// Returns the height of the ground at a point in the map frame: that of the terrain, else of the scan, else of the
/// nearest start pose, else 0.
double groundHeight_m(const GroundSources& sources, const Vec2& at_m);

} // namespace usar::mission
