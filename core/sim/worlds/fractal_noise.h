// Smooth noise over the plane whose detail repeats at ever smaller scales, for hills and for where woods grow.
#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace usar::sim {

/// Fractional Brownian motion of value noise: each octave has half the wavelength and half the amplitude of the one
/// before (robots-and-worlds.md, section 5). Random lattice values come from a hash of the seed, so points can be
/// evaluated in any order. The absolute value is below 2 * amplitude_m.
struct FractalNoise {
    std::uint64_t seed = 0;
    int octaves = 6;
    double wavelength_m = 80.0;
    double amplitude_m = 8.0;

    /// Value at a point; its unit is that of `amplitude_m`.
    double at(const Vec2& point_m) const;
};

/// Returns 0 below `low`, 1 above `high`, and a smooth transition in between.
double smoothStep(double low, double high, double value);

} // namespace usar::sim
