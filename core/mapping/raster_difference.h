// The difference of two height maps, cell by cell.
#pragma once

#include <cstddef>
#include <optional>

#include "core/mapping/raster_export.h"

namespace usar::mapping {

/// What is different between two maps.
struct RasterDifference {
    Raster second_minus_first; ///< It covers both maps; cells that only one of them knows are NaN.
    std::size_t in_both = 0;   ///< So many cells are known in both.
    std::size_t only_first = 0;
    std::size_t only_second = 0;
    double mean_m = 0.0; ///< This and the next two are 0 if no cell is known in both.
    double rms_m = 0.0;
    double largest_m = 0.0; ///< It has no sign.
};

/// Lays one map over the other, each cell on the nearest one; all maps of one cell size have their cells in the same
/// places. Nothing for maps of other cell sizes, without cells, or so far from each other that one raster cannot hold
/// both.
std::optional<RasterDifference> differenceOf(const Raster& first, const Raster& second);

} // namespace usar::mapping
