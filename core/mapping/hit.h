// When a range is a hit, and when it only says that nothing is there.
#pragma once

namespace usar::mapping {

/// In meters. A sensor that hits nothing reports its maximum range with noise, cut to the two decimals of the wire, so
/// a range this close to the maximum is no hit.
inline constexpr double no_hit_margin_m = 0.02;

/// The one rule for everybody who reads ranges: pilots, the map and the views. False for NaN.
inline bool isHit(double range_m, double maximum_m) {
    return range_m < maximum_m - no_hit_margin_m;
}

} // namespace usar::mapping
