// Rays against single solids: vertical cylinder, sphere, upright cone, oriented box; and the surface normals where they
// hit. Exact, in double precision.
#pragma once

#include <limits>

#include "core/base/geometry.h"

namespace usar::sim {

/// A ray in the map frame, in meters; `direction` is a unit vector.
struct Ray {
    Vec3 origin_m = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();
};

/// Result of a ray that misses.
inline constexpr double no_hit_m = std::numeric_limits<double>::infinity();

// Each function returns the distance to the surface: 0 if the ray starts inside the solid, `no_hit_m` on a miss. The
// solids are closed: caps of the cylinder and the base of the cone count.

/// `base_m` is the center of the lower cap.
double hitCylinder(const Ray& ray, const Vec3& base_m, double radius_m, double height_m);
double hitSphere(const Ray& ray, const Vec3& center_m, double radius_m);
/// `base_m` is the center of the base disc; the tip is `height_m` above it.
double hitCone(const Ray& ray, const Vec3& base_m, double radius_m, double height_m);
/// `box_in_map` is the box's rotation.
double hitBox(const Ray& ray, const Vec3& center_m, const Eigen::Matrix3d& box_in_map, const Vec3& half_size_m);

// Normals are unit vectors out of the solid at a point of its surface, in the same frame.

/// `base_m` is the center of the lower cap.
Vec3 normalOfCylinder(const Vec3& point_m, const Vec3& base_m, double height_m);
/// `from_base` is the point relative to the center of the base disc.
Vec3 normalOfCone(const Vec3& from_base, double radius_m, double height_m);
/// Where the ray hits at this distance; back along the ray if it starts inside the box (`distance_m` is 0).
Vec3 normalOfBox(const Ray& ray, double distance_m, const Vec3& center_m, const Eigen::Matrix3d& box_in_map,
                 const Vec3& half_size_m);

} // namespace usar::sim
