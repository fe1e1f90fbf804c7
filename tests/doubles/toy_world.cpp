#include "tests/doubles/toy_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace usar::test {

namespace {

double castAtSphere(const Vec3& origin_m, const Vec3& direction, const Vec3& center_m, double radius_m) {
    const Vec3 to_m = center_m - origin_m;
    const double middle_m = to_m.dot(direction);
    const double half2 = radius_m * radius_m - (to_m.squaredNorm() - middle_m * middle_m);
    const double near_m = half2 < 0.0 ? -1.0 : middle_m - std::sqrt(half2);
    return near_m >= 0.0 ? near_m : std::numeric_limits<double>::infinity();
}

double castAtTrunk(const Vec3& origin_m, const Vec3& direction, const ToyTree& tree) {
    const Vec2 flat = direction.head<2>();
    const double a = flat.squaredNorm();
    const Vec2 from_m = origin_m.head<2>() - tree.at_m;
    const double b = from_m.dot(flat);
    const double c = from_m.squaredNorm() - tree.trunk_radius_m * tree.trunk_radius_m;
    if (a < 1e-9 || b * b - a * c < 0.0)
        return std::numeric_limits<double>::infinity();
    const double near_m = (-b - std::sqrt(b * b - a * c)) / a;
    const bool below_top = origin_m.z() + near_m * direction.z() < tree.trunk_top_m;
    return near_m >= 0.0 && below_top ? near_m : std::numeric_limits<double>::infinity();
}

} // namespace

double ToyWorld::cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const {
    double nearest_m = maximum_m;
    for (const ToyTree& tree : trees) {
        if ((tree.at_m - origin_m.head<2>()).norm() > maximum_m + tree.crown_radius_m + 1.0)
            continue;
        const Vec3 crown_m(tree.at_m.x(), tree.at_m.y(), tree.trunk_top_m);
        nearest_m = std::min({nearest_m, castAtTrunk(origin_m, direction, tree),
                              castAtSphere(origin_m, direction, crown_m, tree.crown_radius_m)});
    }
    constexpr double step_m = 0.25;
    for (double along_m = 0.0; along_m < nearest_m; along_m += step_m) {
        const Vec3 point_m = origin_m + direction * along_m;
        const double over_m = point_m.z() - ground_m(point_m.head<2>());
        if (over_m < 0.0)
            return std::max(0.0, along_m + over_m / std::max(0.05, -direction.z()));
    }
    return nearest_m;
}

double ToyWorld::distance_m(const Vec3& point_m) const {
    double nearest_m = point_m.z() - ground_m(point_m.head<2>());
    for (const ToyTree& tree : trees) {
        const Vec3 crown_m(tree.at_m.x(), tree.at_m.y(), tree.trunk_top_m);
        nearest_m = std::min(nearest_m, (point_m - crown_m).norm() - tree.crown_radius_m);
        if (point_m.z() < tree.trunk_top_m)
            nearest_m = std::min(nearest_m, (point_m.head<2>() - tree.at_m).norm() - tree.trunk_radius_m);
    }
    return nearest_m;
}

} // namespace usar::test
