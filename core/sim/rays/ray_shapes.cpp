#include "core/sim/rays/ray_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::sim {

namespace {

/// The part of a ray that is inside something convex; empty when `leave` < `enter`.
struct Span {
    double enter = -no_hit_m;
    double leave = no_hit_m;
};

constexpr Span nowhere{no_hit_m, -no_hit_m};

Span slab(double origin, double direction, double low, double high) {
    if (direction == 0.0)
        return origin >= low && origin <= high ? Span{} : nowhere;
    const double a = (low - origin) / direction;
    const double b = (high - origin) / direction;
    return a < b ? Span{a, b} : Span{b, a};
}

Span both(const Span& a, const Span& b) {
    return {std::max(a.enter, b.enter), std::min(a.leave, b.leave)};
}

double firstHit(const Span& span) {
    return span.leave < span.enter || span.leave < 0.0 ? no_hit_m : std::max(span.enter, 0.0);
}

/// The part inside the infinite vertical cylinder around (x, y) = 0.
Span column(double x, double y, const Vec3& direction, double radius_m) {
    const double a = direction.x() * direction.x() + direction.y() * direction.y();
    const double c = x * x + y * y - radius_m * radius_m;
    if (a == 0.0)
        return c <= 0.0 ? Span{} : nowhere;
    const double b = x * direction.x() + y * direction.y();
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0)
        return nowhere;
    const double root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

/// Real roots of a t^2 + 2 b t + c, without cancellation; infinite if there are none.
std::pair<double, double> roots(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0)
        return {no_hit_m, no_hit_m};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    return {a != 0.0 ? q / a : no_hit_m, q != 0.0 ? c / q : no_hit_m};
}

constexpr double on_surface_m = 1e-6;

Vec3 outward(const Vec3& from_axis) {
    const Vec3 level{from_axis.x(), from_axis.y(), 0.0};
    return level.norm() > 0.0 ? level.normalized() : Vec3(Vec3::UnitZ());
}

} // namespace

double hitCylinder(const Ray& ray, const Vec3& base_m, double radius_m, double height_m) {
    const Vec3 from_base = ray.origin_m - base_m;
    const Span side = column(from_base.x(), from_base.y(), ray.direction, radius_m);
    if (side.leave < 0.0)
        return no_hit_m;
    return firstHit(both(side, slab(from_base.z(), ray.direction.z(), 0.0, height_m)));
}

double hitSphere(const Ray& ray, const Vec3& center_m, double radius_m) {
    const Vec3 from_center = ray.origin_m - center_m;
    const double b = from_center.dot(ray.direction);
    const double c = from_center.squaredNorm() - radius_m * radius_m;
    if (c <= 0.0)
        return 0.0;
    const double discriminant = b * b - c;
    return b > 0.0 || discriminant < 0.0 ? no_hit_m : -b - std::sqrt(discriminant);
}

double hitCone(const Ray& ray, const Vec3& base_m, double radius_m, double height_m) {
    const Vec3 from_base = ray.origin_m - base_m;
    const Vec3& d = ray.direction;
    const double slope2 = (radius_m / height_m) * (radius_m / height_m);
    const double below_tip = height_m - from_base.z();
    const double xy2 = from_base.x() * from_base.x() + from_base.y() * from_base.y();
    const double c = xy2 - slope2 * below_tip * below_tip;
    if (c <= 0.0 && below_tip >= 0.0 && from_base.z() >= 0.0)
        return 0.0;

    double best = no_hit_m;
    const double a = d.x() * d.x() + d.y() * d.y() - slope2 * d.z() * d.z();
    const double b = from_base.x() * d.x() + from_base.y() * d.y() + slope2 * below_tip * d.z();
    const auto [first, second] = roots(a, b, c);
    for (const double t : {first, second}) {
        const double z = from_base.z() + t * d.z();
        if (t >= 0.0 && t < best && z >= 0.0 && z <= height_m)
            best = t;
    }
    if (from_base.z() < 0.0 && d.z() > 0.0) {
        const double t = -from_base.z() / d.z();
        const double x = from_base.x() + t * d.x();
        const double y = from_base.y() + t * d.y();
        if (t < best && x * x + y * y <= radius_m * radius_m)
            best = t;
    }
    return best;
}

double hitBox(const Ray& ray, const Vec3& center_m, const Eigen::Matrix3d& box_in_map, const Vec3& half_size_m) {
    const Vec3 origin = box_in_map.transpose() * (ray.origin_m - center_m);
    const Vec3 direction = box_in_map.transpose() * ray.direction;
    Span span;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        span = both(span, slab(origin[axis], direction[axis], -half_size_m[axis], half_size_m[axis]));
    return firstHit(span);
}

Vec3 normalOfCylinder(const Vec3& point_m, const Vec3& base_m, double height_m) {
    const Vec3 from_base = point_m - base_m;
    if (from_base.z() >= height_m - on_surface_m)
        return Vec3::UnitZ();
    return from_base.z() <= on_surface_m ? Vec3(-Vec3::UnitZ()) : outward(from_base);
}

Vec3 normalOfCone(const Vec3& from_base, double radius_m, double height_m) {
    if (from_base.z() < on_surface_m)
        return -Vec3::UnitZ();
    return (outward(from_base) * height_m + Vec3::UnitZ() * radius_m).normalized();
}

Vec3 normalOfBox(const Ray& ray, double distance_m, const Vec3& center_m, const Eigen::Matrix3d& box_in_map,
                 const Vec3& half_size_m) {
    if (distance_m <= 0.0)
        return -ray.direction;
    const Vec3 in_box = box_in_map.transpose() * (ray.origin_m + distance_m * ray.direction - center_m);
    Eigen::Index axis = 0;
    in_box.cwiseQuotient(half_size_m).cwiseAbs().maxCoeff(&axis);
    return box_in_map.col(axis) * (in_box[axis] < 0.0 ? -1.0 : 1.0);
}

} // namespace usar::sim
