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

std::optional<double> CourseProfile::groundBelow_m() const {
    constexpr double near_m = 2.0;
    std::optional<double> below_m;
    double nearest_m = near_m;
    for (const ProfilePoint& point : points)
        if (point.height_m && std::abs(point.distance_m) <= nearest_m) {
            nearest_m = std::abs(point.distance_m);
            below_m = *point.height_m;
        }
    return below_m;
}

CourseProfile courseProfile(const HeightMap& map, const Pose& base_in_map, double reach_m) {
    const Vec2 here_m = base_in_map.position_m.head<2>();
    const Vec2 ahead_m = reach_m * Vec2(std::cos(base_in_map.yaw_rad), std::sin(base_in_map.yaw_rad));
    CourseProfile profile{heightProfile(map, here_m, here_m - ahead_m), reach_m, base_in_map.position_m.z()};
    std::ranges::reverse(profile.points);
    for (ProfilePoint& point : profile.points)
        point.distance_m = -point.distance_m;
    const std::vector<ProfilePoint> ahead = heightProfile(map, here_m, here_m + ahead_m);
    if (!ahead.empty()) // without the point below the robot, which is already there
        profile.points.insert(profile.points.end(), ahead.begin() + 1, ahead.end());
    return profile;
}

} // namespace usar::mapping
