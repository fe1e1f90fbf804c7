// Orders of lanes in which the ways between them are short.
#pragma once

#include <vector>

#include "core/mapping/coverage_path.h"

namespace usar::airrobot {

/// Puts lanes into the order in which they are flown from `from_m` on (map frame), always to the nearest end of one
/// next.
void orderFrom(Vec2 from_m, std::vector<mapping::Lane>& lanes);

double lengthOf_m(const std::vector<mapping::Lane>& lanes); ///< without the ways between them

/// The length of the ways from `from_m` to the first lane, between the lanes, and from the last one to `to_m`.
double waysBetween_m(const Vec2& from_m, const std::vector<mapping::Lane>& lanes, const Vec2& to_m);

/// What a robot could fly while it turns at both ends of a lane, in meters.
inline constexpr double turns_m = 5.0;

mapping::Lane turned(mapping::Lane lane); ///< the same lane, flown the other way round

/// The least way that one more lane adds to a tour, with its turns and without the lane itself.
double detour_m(const Vec2& from_m, const std::vector<mapping::Lane>& lanes, const Vec2& to_m,
                const mapping::Lane& lane);

/// Orders lanes so that the ways between `from_m`, them and `to_m` are short: from the order of `orderFrom` on, pieces
/// of the tour are turned around (2-opt, Croes 1958) and single lanes are moved to other places (Or 1976), in either
/// direction, for as long as that shortens it. Never longer than the order of `orderFrom`.
void orderTour(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& to_m);

} // namespace usar::airrobot
