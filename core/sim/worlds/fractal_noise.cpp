#include "core/sim/worlds/fractal_noise.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

/// A random value in -1..1 for a point of the lattice.
double latticeValue(std::uint64_t seed, std::int64_t x, std::int64_t y) {
    const std::uint64_t bits =
        mixed(mixed(mixed(seed) ^ static_cast<std::uint64_t>(x)) ^ static_cast<std::uint64_t>(y));
    return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

/// Its second derivative vanishes at both ends, so that slopes have no kinks along the lattice.
double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double valueNoise(std::uint64_t seed, double x, double y) {
    const double x0 = std::floor(x);
    const double y0 = std::floor(y);
    const auto column = static_cast<std::int64_t>(x0);
    const auto row = static_cast<std::int64_t>(y0);
    const double u = fade(x - x0);
    const double v = fade(y - y0);
    const double below = std::lerp(latticeValue(seed, column, row), latticeValue(seed, column + 1, row), u);
    const double above = std::lerp(latticeValue(seed, column, row + 1), latticeValue(seed, column + 1, row + 1), u);
    return std::lerp(below, above, v);
}

} // namespace

double FractalNoise::at(const Vec2& point_m) const {
    double sum_m = 0.0;
    double amplitude = amplitude_m;
    double scale = 1.0 / wavelength_m;
    for (int octave = 0; octave < octaves; ++octave) {
        sum_m +=
            amplitude * valueNoise(seed + static_cast<std::uint64_t>(octave), scale * point_m.x(), scale * point_m.y());
        amplitude /= 2.0;
        scale *= 2.0;
    }
    return sum_m;
}

double smoothStep(double low, double high, double value) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace usar::sim
