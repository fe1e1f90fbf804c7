// Keeps points apart: tells if a place is far enough from all points so far.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"

namespace usar::sim {

/// Sorts points into buckets over the square +-`half_m`, which all of them must be inside of. Meters.
class Spacing {
public:
    explicit Spacing(double half_m);

    void add(const Vec2& point_m);
    /// True if no point is closer than `distance_m`.
    bool isClear(const Vec2& point_m, double distance_m) const;

private:
    std::ptrdiff_t bucketOf(double coordinate_m) const;

    double half_m_;
    std::ptrdiff_t side_;
    std::vector<std::vector<Vec2>> buckets_;
};

} // namespace usar::sim
