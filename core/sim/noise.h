// Noise of range sensors.
#pragma once

#include "core/base/random.h"

namespace usar::sim {

/// Multiplicative noise: a range r reads r (1 + N(0, sigma)), clamped to the sensor's limits; a miss reads the maximum
/// without noise (robots-and-worlds.md 4.1). Each sensor owns one, with its own random stream.
class RangeNoise {
public:
    RangeNoise(double sigma, Random random) : sigma_(sigma), random_(random) {}

    /// Returns the noisy range. A `range_m` of at least `maximum_m` is a miss.
    double operator()(double range_m, double minimum_m, double maximum_m);

private:
    double sigma_;
    Random random_;
};

} // namespace usar::sim
