// Limits one number of a DRIVE to what the robot can do.
#pragma once

#include <algorithm>
#include <cmath>

namespace usar::sim {

/// Clamps a value to -limit..limit. `normalized` values are hundredths of the limit. NaN gives 0.
inline double limited(double value, double limit, bool normalized) {
    const double physical = normalized ? value / 100.0 * limit : value;
    return std::isnan(physical) ? 0.0 : std::clamp(physical, -limit, limit);
}

} // namespace usar::sim
