// Which cells of a height map count as a mission area: the one rule for every coverage that is shown or saved.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Range of cell indices on one axis, first .. last, both inclusive; none if `last` is below `first`.
struct CellSpan {
    std::int64_t first = 0;
    std::int64_t last = -1;
    std::int64_t count() const { return last < first ? 0 : last - first + 1; }
};

/// Returns the cells whose centers are in [low_m, high_m); the center of cell 0 is at `first_center_m`.
CellSpan centersWithin(double first_center_m, double cell_size_m, double low_m, double high_m);

/// The cells of a height map whose centers are in an area.
struct AreaCells {
    CellSpan columns, rows;
    std::int64_t count() const { return columns.count() * rows.count(); }
};

AreaCells cellsOf(const Rectangle& area_in_map, double cell_size_m);

/// Number of cells of the tile that are in the area and whose height is known.
int knownCellsIn(const AreaCells& area, const HeightTile& tile);

/// Percentage of the area whose height is known, 0..100; nullopt without an area. Looks at each cell of the area in the
/// map's tiles.
std::optional<double> coverage_pct(const HeightMap& map, const Rectangle& area_in_map);

} // namespace usar::mapping
