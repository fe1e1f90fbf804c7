// The order in which lanes are flown, if it is not that of a plan.
#pragma once

#include <limits>
#include <vector>

#include "core/mapping/coverage_path.h"

namespace usar::airrobot {

/// Puts lanes into the order in which they are flown from `from_m` on (map frame), always to the nearest end of one
/// next.
void orderFrom(Vec2 from_m, std::vector<mapping::Lane>& lanes);

/// The length of the ways from `from_m` to the first lane, between the lanes, and from the last one to `to_m`.
double waysBetween_m(const Vec2& from_m, const std::vector<mapping::Lane>& lanes, const Vec2& to_m);

/// How far a robot flies with its battery, and what a charge costs.
struct Endurance {
    double left_m = std::numeric_limits<double>::infinity(); ///< from where it is, until it is home again
    double full_m = std::numeric_limits<double>::infinity(); ///< the same after a charge
    double charge_m = 0.0; ///< what the robot could fly while it lands, charges and takes off
};

/// The length of a flight along these lanes, in their order and directions, that begins at `from_m` and ends at
/// `home_m`. Where the battery lasts only for the way home, the robot flies home, charges and flies back there. Charges
/// and turns are counted as the way that they cost.
double flight_m(const Vec2& from_m, const std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                const Endurance& endurance);

/// For more lanes, an order that takes charges into account would take too long to find in flight.
inline constexpr std::size_t few_lanes = 40;

/// The same as `orderTour`, with flights home for charges if there are few lanes.
void orderFlights(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                  const Endurance& endurance);

/// Changes the order for as long as that makes the flight shorter, if there are few lanes.
void improveFlights(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                    const Endurance& endurance);

/// The least way that one more lane adds to a tour, with its turns and without the lane itself.
double detour_m(const Vec2& from_m, const std::vector<mapping::Lane>& lanes, const Vec2& to_m,
                const mapping::Lane& lane);

/// Orders lanes so that the ways between `from_m`, them and `to_m` are short: from the order of `orderFrom` on, pieces
/// of the tour are turned around (2-opt, Croes 1958) and single lanes are moved to other places (Or 1976), in either
/// direction, for as long as that shortens it. Never longer than the order of `orderFrom`.
void orderTour(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& to_m);

} // namespace usar::airrobot
