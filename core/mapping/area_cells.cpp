#include "core/mapping/area_cells.h"

#include <algorithm>
#include <cmath>

namespace usar::mapping {

namespace {

constexpr std::int64_t tile_side = HeightTile::side;

/// The part of the span that is in the tile with this index, counted from the tile's first cell.
CellSpan withinTile(const CellSpan& span, std::int64_t tile_index) {
    const std::int64_t start = tile_index * tile_side;
    return {std::max(span.first - start, std::int64_t(0)), std::min(span.last - start, tile_side - 1)};
}

} // namespace

CellSpan centersWithin(double first_center_m, double cell_size_m, double low_m, double high_m) {
    const auto index = [&](double at_m) {
        return static_cast<std::int64_t>(std::ceil((at_m - first_center_m) / cell_size_m - 1e-9));
    };
    return {index(low_m), index(high_m) - 1};
}

AreaCells cellsOf(const Rectangle& area_in_map, double cell_size_m) {
    const double first_center_m = cell_size_m / 2.0;
    return {centersWithin(first_center_m, cell_size_m, area_in_map.min_m.x(), area_in_map.max_m.x()),
            centersWithin(first_center_m, cell_size_m, area_in_map.min_m.y(), area_in_map.max_m.y())};
}

int knownCellsIn(const AreaCells& area, const HeightTile& tile) {
    const CellSpan columns = withinTile(area.columns, tile.index.column);
    const CellSpan rows = withinTile(area.rows, tile.index.row);
    int known = 0;
    for (std::int64_t row = rows.first; row <= rows.last; ++row)
        for (std::int64_t column = columns.first; column <= columns.last; ++column)
            known += !std::isnan(tile.height_m[static_cast<std::size_t>(row * tile_side + column)]);
    return known;
}

std::optional<double> coverage_pct(const HeightMap& map, const Rectangle& area_in_map) {
    if (area_in_map.empty())
        return std::nullopt;
    const AreaCells area = cellsOf(area_in_map, map.cellSize_m());
    std::int64_t known = 0;
    for (const GridIndex& index : map.tileIndices())
        known += knownCellsIn(area, *map.tile(index));
    return area.count() == 0 ? 0.0 : 100.0 * double(known) / double(area.count());
}

} // namespace usar::mapping
