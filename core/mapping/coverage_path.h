// Lanes that cover a rectangle: the survey pattern of the thesis (4.1).
#pragma once

#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/result.h"

namespace usar::mapping {

struct CoverageOptions {
    double lane_spacing_m = 10.0;    ///< at most; lanes are spread evenly
    double quadrant_limit_m = 150.0; ///< an area with a longer side is cut into equal quadrants, scanned one by one
};

/// One straight lane; scanned from start to end.
struct Lane {
    Vec2 start_m = Vec2::Zero();
    Vec2 end_m = Vec2::Zero();
    int quadrant = 0; ///< index into CoveragePlan::quadrants
    bool operator==(const Lane&) const = default;
};

/// Metres, map frame.
struct CoveragePlan {
    std::vector<Lane> lanes;          ///< in flying order: boustrophedon along the longer side
    std::vector<Rectangle> quadrants; ///< in flying order
    double lane_length_m = 0.0;       ///< sum of the lanes
    double transit_length_m = 0.0;    ///< from the base, between lanes, and back to the base
};

/// Lanes along the longer side of each quadrant, from the corner nearest to where the robot then is (the base for the
/// first). The outer lanes lie half a spacing inside the border, so every point of the area is within half a spacing
/// of a lane, and no fewer lanes would do. Quadrants are visited in the order with the least transit of those tried:
/// to and fro by rows or by columns from each corner, and always the nearest next.
/// An area without size, one that needs more than 100 000 lanes, a spacing or a limit that is not positive, and
/// anything that is not finite is an error.
Result<CoveragePlan> planCoverage(const Rectangle& area_in_map, const Vec2& base_in_map_m,
                                  const CoverageOptions& options);

/// Flying time of a plan at two speeds, without obstacles and charging; infinite for a speed that is not positive.
Seconds estimatedTime(const CoveragePlan& plan, double scan_speed_m_s, double transit_speed_m_s);

} // namespace usar::mapping
