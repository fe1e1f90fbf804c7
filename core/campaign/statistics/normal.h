// The standard normal distribution.
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <unsupported/Eigen/SpecialFunctions>

namespace usar::campaign {

/// The probability of a value of at most `z`. By the complement, because the tails keep their digits so.
inline double normalCumulative(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// The value that is not exceeded with `probability`, which lies between 0 and 1; infinite at both ends.
inline double normalQuantile(double probability) {
    return Eigen::numext::ndtri(probability);
}

/// How many standard deviations an interval with this confidence reaches to each side: 1.96 for 0.95.
inline double normalReach(double confidence) {
    return normalQuantile(0.5 + confidence / 2.0);
}

} // namespace usar::campaign
