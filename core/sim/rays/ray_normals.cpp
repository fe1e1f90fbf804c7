#include "core/sim/rays/ray_normals.h"

namespace usar::sim {

namespace {

constexpr double on_surface_m = 1e-6;

Vec3 crownCenter(const Plant& plant) {
    return plant.base_in_map_m + Vec3{0.0, 0.0, plant.trunk_height_m};
}

Vec3 outward(const Vec3& from_axis) {
    const Vec3 level{from_axis.x(), from_axis.y(), 0.0};
    return level.norm() > 0.0 ? level.normalized() : Vec3(Vec3::UnitZ());
}

Vec3 normalOfCone(const Vec3& from_base, double radius_m, double height_m) {
    if (from_base.z() < on_surface_m)
        return -Vec3::UnitZ();
    return (outward(from_base) * height_m + Vec3::UnitZ() * radius_m).normalized();
}

} // namespace

bool isCrown(const Plant& plant, const Ray& ray, double distance_m) {
    if (plant.crown_radius_m <= 0.0)
        return false;
    const Vec3 crown_m = crownCenter(plant);
    const double hit_m = plant.crown == CrownShape::Sphere
                             ? hitSphere(ray, crown_m, plant.crown_radius_m)
                             : hitCone(ray, crown_m, plant.crown_radius_m, plant.crown_height_m);
    return hit_m <= distance_m + on_surface_m;
}

Vec3 normalOfPlant(const Plant& plant, const Ray& ray, double distance_m) {
    if (distance_m <= 0.0)
        return -ray.direction;
    const Vec3 point_m = ray.origin_m + distance_m * ray.direction;
    if (!isCrown(plant, ray, distance_m))
        return normalOfCylinder(point_m, plant.base_in_map_m, plant.trunk_height_m);
    const Vec3 from_crown = point_m - crownCenter(plant);
    return plant.crown == CrownShape::Sphere ? from_crown.normalized()
                                             : normalOfCone(from_crown, plant.crown_radius_m, plant.crown_height_m);
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

Vec3 normalOfGround(const Terrain& terrain, const Vec2& point_m) {
    const double step_m = terrain.step_m();
    const auto rise = [&](const Vec2& way) {
        return (terrain.height_m(point_m + way) - terrain.height_m(point_m - way)) / (2.0 * step_m);
    };
    return Vec3{-rise({step_m, 0.0}), -rise({0.0, step_m}), 1.0}.normalized();
}

Vec3 normalOfCylinder(const Vec3& point_m, const Vec3& base_m, double height_m) {
    const Vec3 from_base = point_m - base_m;
    if (from_base.z() >= height_m - on_surface_m)
        return Vec3::UnitZ();
    return from_base.z() <= on_surface_m ? Vec3(-Vec3::UnitZ()) : outward(from_base);
}

} // namespace usar::sim
