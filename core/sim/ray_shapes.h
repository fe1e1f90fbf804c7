// Rays against single solids: vertical cylinder, sphere, upright cone, oriented box. Exact, double precision.
#pragma once

#include <limits>

#include "core/base/geometry.h"

namespace usar::sim {

/// `direction` is a unit vector; map frame, metres.
struct Ray {
    Vec3 origin_m = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();
};

inline constexpr double no_hit_m = std::numeric_limits<double>::infinity();

// Each function answers the distance to the surface, 0 when the ray starts inside the solid, `no_hit_m` otherwise.
// The solids are closed: caps of the cylinder and the base of the cone count.

/// `base_m` is the center of the lower cap.
double hitCylinder(const Ray& ray, const Vec3& base_m, double radius_m, double height_m);
double hitSphere(const Ray& ray, const Vec3& center_m, double radius_m);
/// `base_m` is the center of the base disc; the tip is `height_m` above it.
double hitCone(const Ray& ray, const Vec3& base_m, double radius_m, double height_m);
double hitBox(const Ray& ray, const Vec3& center_m, const Eigen::Matrix3d& box_in_map, const Vec3& half_size_m);

} // namespace usar::sim
