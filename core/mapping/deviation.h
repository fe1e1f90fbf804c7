// How uncertain the heights of a map are because the path of the robot is.
#pragma once

#include "core/mapping/height_map.h"
#include "core/mapping/path_correction.h"
#include "core/mapping/raster_export.h"

namespace usar::mapping {

/// Standard deviation of each known height of `heights`, a raster of `map`, in meters; NaN elsewhere. It is that of the
/// path at the newest scan that wrote the cell: sqrt(sz^2 + (gx sx)^2 + (gy sy)^2) with the slope (gx, gy) of the
/// raster there. The noise of the range scanner and of the angles is not in it. Zero for a cell of no kept scan.
Raster deviationOf(const Raster& heights, const HeightMap& map, const ScanStore& store,
                   const PathCorrection& correction);

} // namespace usar::mapping
