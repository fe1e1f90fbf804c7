#include "core/base/outline.h"

#include <algorithm>

namespace usar {

namespace {

constexpr int corners_of_a_circle = 24;

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

Outline seenFromAbove(const Pose& body, const std::vector<Vec3>& points_m) {
    std::vector<Vec2> flat_m;
    for (const Vec3& point_m : points_m)
        flat_m.emplace_back((body * point_m).head<2>());
    return hullOf(std::move(flat_m));
}

} // namespace

/// Andrew's monotone chain.
Outline hullOf(std::vector<Vec2> points) {
    std::ranges::sort(points,
                      [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
    Outline hull;
    const auto addAll = [&hull](auto first, auto last) {
        const std::size_t begin = hull.size();
        for (; first != last; ++first) {
            while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), *first) <= 0.0)
                hull.pop_back();
            hull.push_back(*first);
        }
        if (!hull.empty())
            hull.pop_back(); // The other chain begins with this point.
    };
    addAll(points.begin(), points.end());
    addAll(points.rbegin(), points.rend());
    return hull;
}

Outline outlineOfBox(const Pose& center, const Vec3& size_m) {
    std::vector<Vec3> corners_m;
    const Vec3 half_m = size_m / 2.0;
    for (int corner = 0; corner < 8; ++corner)
        corners_m.emplace_back(corner & 1 ? half_m.x() : -half_m.x(), corner & 2 ? half_m.y() : -half_m.y(),
                               corner & 4 ? half_m.z() : -half_m.z());
    return seenFromAbove(center, corners_m);
}

Outline outlineOfCylinder(const Pose& center, const Vec3& size_m) {
    std::vector<Vec3> rims_m;
    const Vec3 half_m = size_m / 2.0;
    for (int i = 0; i < corners_of_a_circle; ++i) {
        const double angle_rad = 2.0 * pi * i / corners_of_a_circle;
        const Vec2 on_circle(half_m.x() * std::cos(angle_rad), half_m.y() * std::sin(angle_rad));
        rims_m.emplace_back(on_circle.x(), on_circle.y(), half_m.z());
        rims_m.emplace_back(on_circle.x(), on_circle.y(), -half_m.z());
    }
    return seenFromAbove(center, rims_m);
}

Outline outlineOfSphere(const Vec2& center_m, double radius_m) {
    return outlineOfCylinder(Pose{Vec3(center_m.x(), center_m.y(), 0.0)}, Vec3(2.0 * radius_m, 2.0 * radius_m, 0.0));
}

} // namespace usar
