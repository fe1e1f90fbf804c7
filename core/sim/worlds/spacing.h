// Points that keep their distance: asks whether a place is clear of all points so far.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"

namespace usar::sim {

/// Buckets over the square +-`half_m`; points must lie inside. Metres.
class Spacing {
public:
    explicit Spacing(double half_m);

    void add(const Vec2& point_m);
    /// No point is nearer than `distance_m`.
    bool isClear(const Vec2& point_m, double distance_m) const;

private:
    std::ptrdiff_t bucketOf(double coordinate_m) const;

    double half_m_;
    std::ptrdiff_t side_;
    std::vector<std::vector<Vec2>> buckets_;
};

} // namespace usar::sim
