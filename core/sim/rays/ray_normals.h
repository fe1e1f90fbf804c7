// Surface normals where a ray has hit: unit vectors out of the solid, map frame. If the ray starts inside the solid
// (`distance_m` is 0), the normal points back along the ray.
#pragma once

#include "core/sim/rays/ray_shapes.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// True if at this distance the ray hits the crown, not the trunk.
bool isCrown(const Plant& plant, const Ray& ray, double distance_m);
/// Normal of crown or trunk, whichever the ray has hit at this distance.
Vec3 normalOfPlant(const Plant& plant, const Ray& ray, double distance_m);
/// `box_in_map` is the box's rotation.
Vec3 normalOfBox(const Ray& ray, double distance_m, const Vec3& center_m, const Eigen::Matrix3d& box_in_map,
                 const Vec3& half_size_m);
/// Normal of a smooth surface through the posts, so that the triangles do not show.
Vec3 normalOfGround(const Terrain& terrain, const Vec2& point_m);
/// Normal of an upright cylinder; `base_m` is the center of its lower cap.
Vec3 normalOfCylinder(const Vec3& point_m, const Vec3& base_m, double height_m);

} // namespace usar::sim
