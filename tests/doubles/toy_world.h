// A world of formulas for flying behaviors in unit tests: rolling ground, trunks, round crowns.
#pragma once

#include <functional>
#include <vector>

#include "core/base/geometry.h"

namespace usar::test {

/// A crown of radius 0 is a bare trunk.
struct ToyTree {
    Vec2 at_m = Vec2::Zero();
    double trunk_radius_m = 0.2;
    double trunk_top_m = 7.0; ///< map z; the crown is centered there
    double crown_radius_m = 2.0;
};

struct ToyWorld {
    std::function<double(const Vec2&)> ground_m = [](const Vec2&) { return 0.0; };
    std::vector<ToyTree> trees;

    /// Distance along the ray to the first thing; `maximum_m` on a miss.
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;
    /// Distance from a point to the nearest surface, negative within; good near surfaces only.
    double distance_m(const Vec3& point_m) const;
};

} // namespace usar::test
