// Fills small holes of a raster of heights by interpolation, and tells which cells these are.
#pragma once

#include <cstddef>

#include "core/mapping/raster_export.h"

namespace usar::mapping {

/// A hole is smaller than this.
inline constexpr double hole_limit_m2 = 1.0;

/// A raster whose small holes are filled.
struct FilledRaster {
    Raster heights; ///< as they were measured, and in the holes as they are interpolated
    Raster mask;    ///< 1 where a height is interpolated, 0 where it was there before, NaN where it is unknown
    std::size_t filled_cells = 0;

    double filled_m2() const { return double(filled_cells) * heights.cell_size_m * heights.cell_size_m; }
};

/// Fills each hole of less than `limit_m2`. A hole is a group of unknown cells that touch by a side or a corner; one
/// that touches the border of the raster is no hole, because nobody knows how far it goes. Heights come from the known
/// cells around the hole, the nearer ones counting more: where these are of two floors, as at the edge of a crown, a
/// cell takes one of the two and not a height in between, which nothing has. `raster` itself stays as it is.
FilledRaster withHolesFilled(const Raster& raster, double limit_m2 = hole_limit_m2);

/// The surface of the holes that `withHolesFilled` would fill, in square meters, in less time.
double holes_m2(const Raster& raster, double limit_m2 = hole_limit_m2);

} // namespace usar::mapping
