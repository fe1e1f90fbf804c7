#include "core/sim/rays/ray_bundle.h"

#include <cassert>

namespace usar::sim {

namespace {

constexpr double edge_slack_m = 1e-6;

/// Positive when `b` is to the left of `a`.
double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

RayBundle::RayBundle(const Vec3& origin_m, std::span<const Vec3> directions)
    : origin_m_(origin_m)
    , directions_(directions) {
    assert(!directions.empty());
    ahead_ = leftmost_ = rightmost_ = directions.front().head<2>();
    for (const Vec3& direction : directions) {
        lowest_ = lowest_.cwiseMin(direction);
        highest_ = highest_.cwiseMax(direction);
        const Vec2 way = direction.head<2>();
        narrow_ = narrow_ && way.dot(ahead_) > 0.0;
        if (cross(leftmost_, way) > 0.0)
            leftmost_ = way;
        if (cross(rightmost_, way) < 0.0)
            rightmost_ = way;
    }
    if (!narrow_)
        return;
    ahead_.normalize();
    leftmost_.normalize();
    rightmost_.normalize();
}

Eigen::AlignedBox3d RayBundle::box(double length_m) const {
    const Vec3 hair = Vec3::Constant(edge_slack_m);
    return {origin_m_ + length_m * lowest_ - hair, origin_m_ + length_m * highest_ + hair};
}

bool RayBundle::mayMeetColumn(const Vec2& center_m, double radius_m, double length_m) const {
    const Vec2 to_center_m = center_m - origin_m_.head<2>();
    const double wide_m = radius_m + edge_slack_m;
    const double far_m = wide_m + length_m;
    if (to_center_m.squaredNorm() > far_m * far_m)
        return false;
    return !narrow_ || (cross(leftmost_, to_center_m) <= wide_m && cross(rightmost_, to_center_m) >= -wide_m &&
                        ahead_.dot(to_center_m) >= -wide_m);
}

} // namespace usar::sim
