// Lines of equal height on a raster.
#pragma once

#include <vector>

#include "core/mapping/byte_stream.h"
#include "core/mapping/raster_export.h"

namespace usar::mapping {

/// A line of equal height: at least two points, map frame, no two neighbors equal. A closed line ends with its first
/// point; others end at the edge of the raster or of unknown cells.
struct ContourLine {
    double height_m = 0.0;
    std::vector<Vec2> points_m;
};

/// Marching squares between the centers of cells, with heights interpolated linearly along the sides of the squares. A
/// square with an unknown corner has no line. In a saddle the mean of the four corners decides which of them are
/// joined. Lines begin in the order of the raster's rows.
std::vector<ContourLine> contoursAt(const Raster& raster, double height_m);

/// The distance in height between two contours: 1, 2 or 5 times a power of ten, such that there are at most 20 of them,
/// and not less than 1 cm. Nothing for a raster without known cells.
std::optional<double> contourInterval_m(const Raster& raster);

/// The contours at all multiples of the interval within the range of the heights, as GeoJSON with coordinates in meters
/// in the map frame, four decimals, and the property `elevation_m`. A map without contours is a collection without
/// features. Sends a line of text for each contour; false as soon as `sink` is.
bool writeContours(const Raster& raster, const ByteSink& sink);

} // namespace usar::mapping
