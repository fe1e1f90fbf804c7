// Which hits of the belly scanner may be on something that goes on above them.
#pragma once

namespace usar::airrobot {

/// The scanner sees nothing higher than itself, unless the robot rolls. Heights are map z.
inline bool mayGoOn(double hit_m, double scanner_m) {
    constexpr double level_with_m = 0.5;
    return hit_m > scanner_m - level_with_m;
}

/// True if a later hit, on which nothing goes on, shows that nothing goes on above the highest one either.
inline bool showsTop(double hit_m, double highest_m) {
    constexpr double near_top_m = 0.7;
    return hit_m > highest_m - near_top_m;
}

} // namespace usar::airrobot
