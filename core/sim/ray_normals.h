// Which way a surface faces where a ray has hit it. Unit vectors out of the solid, map frame; from inside one, back
// along the ray.
#pragma once

#include "core/sim/ray_shapes.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Whether it is the crown that the ray hits at this distance, not the trunk.
bool isCrown(const Plant& plant, const Ray& ray, double distance_m);
Vec3 normalOfPlant(const Plant& plant, const Ray& ray, double distance_m);
Vec3 normalOfBox(const Ray& ray, double distance_m, const Vec3& center_m, const Eigen::Matrix3d& box_in_map,
                 const Vec3& half_size_m);
/// Of a smooth surface through the posts, so that triangles do not show.
Vec3 normalOfGround(const Terrain& terrain, const Vec2& point_m);
/// `base_m` is the center of the lower cap.
Vec3 normalOfCylinder(const Vec3& point_m, const Vec3& base_m, double height_m);

} // namespace usar::sim
