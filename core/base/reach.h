// Where a flying robot can get to: what the score of a mission asks, and what only a simulator can answer.
#pragma once

#include <functional>

#include "core/base/geometry.h"

namespace usar {

/// How a robot flies. Heights are over the ground, meters.
struct FlightLimits {
    Vec3 start_in_map_m = Vec3::Zero();
    double scan_altitude_m = 6.0;
    double maximum_height_m = 19.0; ///< it climbs over what is lower; the scan altitude if it never climbs
    double body_radius_m = 0.5;
    bool operator==(const FlightLimits&) const = default;
};

/// Says whether a flying robot can scan a place, and if not, why.
enum class Reach {
    Scanned,      ///< it can fly there, or close enough to see the place
    OutsideWorld, ///< the world has ended
    OverWater,    ///< it can fly there, but the water is deeper than its scan altitude
    ShutOff       ///< something solid is in the way
};

/// Answers for points of the map frame; may be called in any thread. Empty: it is not known.
using ReachMap = std::function<Reach(const Vec2&)>;

} // namespace usar
