#include "core/mapping/profile.h"

#include <algorithm>
#include <cmath>

namespace usar::mapping {

std::vector<ProfilePoint> heightProfile(const HeightMap& map, const Vec2& start_m, const Vec2& end_m) {
    constexpr double maximum_points = 100'000;
    const double length_m = (end_m - start_m).norm();
    if (!std::isfinite(length_m))
        return {};
    const double steps = std::min(std::max(1.0, std::ceil(length_m / map.cellSize_m())), maximum_points);
    std::vector<ProfilePoint> points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    for (double i = 0.0; i <= steps; ++i) {
        const Vec2 point_m = start_m + (end_m - start_m) * (i / steps);
        points.push_back({length_m * (i / steps), map.height_m(map.cellAt(point_m))});
    }
    return points;
}

} // namespace usar::mapping
