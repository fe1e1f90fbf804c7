#include "core/mission/runs/area_cells.h"

#include <algorithm>
#include <cmath>

namespace usar::mission {

namespace {

constexpr std::int64_t side = mapping::HeightTile::side;

/// The part of the span that is in the tile with this index, counted from the tile's first cell.
CellSpan withinTile(const CellSpan& span, std::int64_t tile_index) {
    const std::int64_t start = tile_index * side;
    return {std::max(span.first - start, std::int64_t(0)), std::min(span.last - start, side - 1)};
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

int knownCellsIn(const AreaCells& area, const mapping::HeightTile& tile) {
    const CellSpan columns = withinTile(area.columns, tile.index.column);
    const CellSpan rows = withinTile(area.rows, tile.index.row);
    int known = 0;
    for (std::int64_t row = rows.first; row <= rows.last; ++row)
        for (std::int64_t column = columns.first; column <= columns.last; ++column)
            known += !std::isnan(tile.height_m[static_cast<std::size_t>(row * side + column)]);
    return known;
}

} // namespace usar::mission
