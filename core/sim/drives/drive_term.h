// One number of a DRIVE as the robot can do it.
#pragma once

#include <algorithm>
#include <cmath>

namespace usar::sim {

/// `normalized` values are hundredths of the limit. What is no number asks for nothing.
inline double limited(double value, double limit, bool normalized) {
    const double physical = normalized ? value / 100.0 * limit : value;
    return std::isnan(physical) ? 0.0 : std::clamp(physical, -limit, limit);
}

} // namespace usar::sim
