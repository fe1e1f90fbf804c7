// Plans lanes that cover a rectangle: the survey pattern of the thesis (4.1).
#pragma once

#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/result.h"

namespace usar::mapping {

/// Both values must be positive, and the spacing finite.
struct CoverageOptions {
    double lane_spacing_m;           ///< maximum; lanes are spread evenly
    double quadrant_limit_m = 150.0; ///< an area with a longer side is divided into equal quadrants, scanned one by one
    bool returns = false;            ///< The robot flies to its base after each quadrant.
    bool crosswise = false;          ///< Lanes run along the shorter side of each quadrant.
};

/// One straight lane in the map frame, scanned from start to end.
struct Lane {
    Vec2 start_m = Vec2::Zero();
    Vec2 end_m = Vec2::Zero();
    int quadrant = 0; ///< index into CoveragePlan::quadrants
    int sortie = 0;   ///< The robot may fly home between two lanes in a row whose sorties differ.
};

/// The result of planCoverage.
struct CoveragePlan {
    std::vector<Lane> lanes;          ///< in flying order: back and forth along a side, a sortie for each quadrant
    std::vector<Rectangle> quadrants; ///< in flying order
    double lane_length_m = 0.0;       ///< total length of the lanes
    double transit_length_m = 0.0;    ///< from the base, between lanes, and back to the base
};

/// The height over level ground from which a scanner with a degree between its beams shows points no farther apart than
/// this up to 58 degrees aside: 16 times that distance, by h pi/180 / cos^2 t. From higher up, more ground is within
/// reach, but crowns hide more of what is farther aside; half a meter from 8 m was the fastest for `tall_test`
/// (measured.md). It is 2 m at least and 10 m at most, from where a reach of 19 m ends at that angle.
double altitudeFor_m(double ground_resolution_m);

/// Plans lanes along a side of each quadrant, usually the longer one, starting at the corner nearest to the robot's
/// position at that time (the base for the first quadrant, and for all if it returns there). The outer lanes are half a
/// spacing inside the border, so that every point of the area is within half a spacing of a lane; fewer lanes would not
/// suffice. Quadrants are visited in the order with the shortest transit among those tried: back and forth by rows or
/// by columns from each corner, and, for up to 1600 quadrants, always the nearest one next. Returns an error if the
/// area has no size or needs more than 100 000 lanes, if an option is invalid, or if a coordinate is not finite.
Result<CoveragePlan> planCoverage(const Rectangle& area_in_map, const Vec2& base_in_map_m,
                                  const CoverageOptions& options);

} // namespace usar::mapping
