// How the wind grows with the height above the ground.
#pragma once

#include <cmath>

namespace usar::sim {

/// The speed of a wind is stated at this height, as weather stations do (WMO-No. 8, Guide to Meteorological Instruments
/// and Methods of Observation, part I, chapter 5).
inline constexpr double wind_reference_m = 10.0;
/// Open flat terrain with grass and few isolated obstacles, by the same chapter's table of terrain classes.
inline constexpr double roughness_length_m = 0.03;

/// The wind at this height above the ground, as a share of that at 10 m: the logarithmic profile of neutral air without
/// a displacement. The air rests up to the roughness length.
inline double windShare(double height_m) {
    if (height_m <= roughness_length_m)
        return 0.0;
    return std::log(height_m / roughness_length_m) / std::log(wind_reference_m / roughness_length_m);
}

} // namespace usar::sim
