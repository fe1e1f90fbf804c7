// The height at one point, looked up in tiles that a height map has handed out.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Tiles by their index, as whoever collects them keeps them.
using HeightTiles = std::map<GridIndex, std::shared_ptr<const HeightTile>>;

/// Data of one cell.
struct HeightProbe {
    float height_m = 0.0f; ///< value of the height array: the mean of the measurements
    int hits = 0;          ///< number of measurements; 0: interpolated between two beams
};

/// Data of the cell at this point of the map frame; nullopt if its height is unknown. `cell_size_m` is the side of the
/// tiles' cells.
std::optional<HeightProbe> probeHeight(const HeightTiles& tiles, double cell_size_m, const Vec2& point_in_map_m);

} // namespace usar::mapping
