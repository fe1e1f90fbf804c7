#include "core/mapping/height_probe.h"

#include <cmath>
#include <cstddef>

namespace usar::mapping {

std::optional<HeightProbe> probeHeight(const HeightTiles& tiles, double cell_size_m, const Vec2& point_in_map_m) {
    const Vec2 cell = (point_in_map_m / cell_size_m).array().floor().matrix();
    if (!(cell.cwiseAbs().maxCoeff() < 1e9))
        return std::nullopt;
    const Vec2 tile_index = (cell / double(HeightTile::side)).array().floor().matrix();
    const GridIndex index{static_cast<std::int32_t>(tile_index.x()), static_cast<std::int32_t>(tile_index.y())};
    const auto found = tiles.find(index);
    if (found == tiles.end())
        return std::nullopt;
    const Vec2 within = cell - tile_index * double(HeightTile::side);
    const auto at = static_cast<std::size_t>(within.y()) * HeightTile::side + static_cast<std::size_t>(within.x());
    const float height_m = found->second->height_m[at];
    if (!std::isfinite(height_m))
        return std::nullopt;
    return HeightProbe{height_m, found->second->hits[at]};
}

} // namespace usar::mapping
