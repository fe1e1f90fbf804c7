// What is left of a mission area that was scanned in part.
#pragma once

#include <algorithm>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mission {

/// Gaps up to this size stay open in a whole run, too: shadows behind trees and rocks. Square meters; the largest ones
/// measured after the shipped missions were 2.9 m² (quick_scan, three seeds) and 14.1 m² (tall_test).
inline constexpr double usual_gap_m2 = 20.0;
/// The same for this area: one percent of it, between what the smallest whole runs leave and `usual_gap_m2`.
inline double usualGap_m2(const Rectangle& area) {
    return std::clamp(0.01 * area.area_m2(), 3.0, usual_gap_m2);
}

/// Returns the smallest rectangle that contains every gap of more than `largest_gap_m2`; empty if there is none. A gap
/// is a set of unknown cells of the area that are joined by their sides. With 0, every unknown cell is in the
/// rectangle. It is inside the area (meters, map frame), and its sides are those of cells or of the area. The tiles
/// have cells of `cell_size_m`. Looks at every cell, so do not call it in the GUI thread.
Rectangle remainingArea(const Rectangle& area_in_map, const mapping::HeightTiles& tiles, double cell_size_m,
                        double largest_gap_m2 = usual_gap_m2);

} // namespace usar::mission
