// Where the beams of a scan hit something.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace usar::mapping {

/// The geometry of a scan: beam k leaves the scanner at the angle -fov/2 + k * resolution (counterclockwise positive
/// about the scanner's z axis; 0 is its x axis). Ranges that are at or beyond `maximum_m`, not positive, or NaN are
/// misses. Does not own the ranges.
struct Beams {
    std::span<const double> ranges_m;
    double resolution_rad = 0.0;
    double fov_rad = 0.0;
    double maximum_m = 20.0;

    double angle_rad(std::size_t beam) const { return -fov_rad / 2.0 + double(beam) * resolution_rad; }
};

/// Directions of a scanner's beams, kept for the next scan, which usually has the same.
class BeamDirections {
public:
    /// Unit vectors in the scanner's plane, one for each of `count` beams, whose angles are those of Beams.
    const std::vector<Vec2>& of(double resolution_rad, double fov_rad, std::size_t count);

private:
    std::vector<Vec2> directions_;
    std::pair<double, double> geometry_{}; ///< resolution and field of view, in rad, that they have
};

/// Computes hits.
class HitFinder {
public:
    /// Points hit by the beams, in the map frame and in beam order; NaN for misses. With a pose that is not finite, all
    /// beams are misses.
    void find(const Beams& beams, const Pose& scanner_in_map, std::vector<Vec3>& hits_m);

private:
    BeamDirections directions_;
};

} // namespace usar::mapping
