#include "core/sim/camera/seen_solids.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

double hit(const SphereShape& shape, const Ray& ray) {
    return hitSphere(ray, Vec3::Zero(), shape.radius_m);
}
double hit(const BoxShape& shape, const Ray& ray) {
    return hitBox(ray, Vec3::Zero(), Eigen::Matrix3d::Identity(), shape.size_m / 2.0);
}
double hit(const CylinderShape& shape, const Ray& ray) {
    return hitCylinder(ray, {0.0, 0.0, -shape.height_m / 2.0}, shape.radius_m, shape.height_m);
}
double hit(const CapsuleShape& shape, const Ray& ray) {
    const Vec3 end_m{0.0, 0.0, shape.height_m / 2.0};
    return std::min({hitCylinder(ray, -end_m, shape.radius_m, shape.height_m), hitSphere(ray, end_m, shape.radius_m),
                     hitSphere(ray, -end_m, shape.radius_m)});
}

Vec3 normalAt(const SphereShape&, const Ray& ray, double distance_m) {
    return (ray.origin_m + distance_m * ray.direction).normalized();
}
Vec3 normalAt(const BoxShape& shape, const Ray& ray, double distance_m) {
    return normalOfBox(ray, distance_m, Vec3::Zero(), Eigen::Matrix3d::Identity(), shape.size_m / 2.0);
}
Vec3 normalAt(const CylinderShape& shape, const Ray& ray, double distance_m) {
    return normalOfCylinder(ray.origin_m + distance_m * ray.direction, {0.0, 0.0, -shape.height_m / 2.0},
                            shape.height_m);
}
Vec3 normalAt(const CapsuleShape& shape, const Ray& ray, double distance_m) {
    const Vec3 point_m = ray.origin_m + distance_m * ray.direction;
    const double along_m = std::clamp(point_m.z(), -shape.height_m / 2.0, shape.height_m / 2.0);
    return (point_m - Vec3{0.0, 0.0, along_m}).normalized();
}

Ray inFrameOf(const SeenSolid& solid, const Ray& ray) {
    return {solid.solid_in_map.transpose() * (ray.origin_m - solid.center_m),
            solid.solid_in_map.transpose() * ray.direction};
}

double distanceTo(const SeenSolid& solid, const Ray& ray) {
    const Vec3 to_center = solid.center_m - ray.origin_m;
    const double along_m = to_center.dot(ray.direction);
    if (to_center.squaredNorm() - along_m * along_m > solid.radius_m * solid.radius_m)
        return no_hit_m;
    const Ray local = inFrameOf(solid, ray);
    return std::visit([&](const auto& shape) { return hit(shape, local); }, solid.shape);
}

} // namespace

Eye::Eye(const SeenFrom& camera)
    : position_m_(camera.camera_in_map.translation())
    , width_px_(camera.width_px)
    , height_px_(camera.height_px) {
    const Eigen::Matrix3d turned = camera.camera_in_map.linear();
    const double pixel = 2.0 * std::tan(camera.field_of_view_rad / 2.0) / width_px_;
    ahead_ = turned.col(0);
    right_ = -pixel * turned.col(1);
    down_ = -pixel * turned.col(2);
}

Ray Eye::through(double x_px, double y_px) const {
    const Vec3 toward = ahead_ + (x_px - width_px_ / 2.0) * right_ + (y_px - height_px_ / 2.0) * down_;
    return {position_m_, toward.normalized()};
}

SeenSolids::SeenSolids(const CameraScene& scene, const Eye& eye)
    : tile_columns_((eye.width_px() + tile_px - 1) / tile_px) {
    for (const SeenSolid& solid : scene.solids)
        all_.push_back(&solid);
    const int tile_rows = (eye.height_px() + tile_px - 1) / tile_px;
    tiles_.resize(static_cast<std::size_t>(tile_columns_ * tile_rows));
    for (int row = 0; row < tile_rows; ++row)
        for (int column = 0; column < tile_columns_; ++column) {
            const Ray middle = eye.through((column + 0.5) * tile_px, (row + 0.5) * tile_px);
            // A cone around the tile, to the farther of these two corners and a tenth more. The other two corners are
            // not considered, although one of them may be farther off the middle ray.
            const double reach_rad =
                std::max(
                    std::acos(
                        std::min(1.0, middle.direction.dot(eye.through(column * tile_px, row * tile_px).direction))),
                    std::acos(std::min(1.0, middle.direction.dot(
                                                eye.through((column + 1) * tile_px, (row + 1) * tile_px).direction)))) *
                1.1;
            for (const SeenSolid& solid : scene.solids) {
                const Vec3 to_solid = solid.center_m - middle.origin_m;
                const double distance_m = to_solid.norm();
                const bool around_eye = distance_m <= solid.radius_m;
                if (around_eye || std::acos(std::clamp(to_solid.dot(middle.direction) / distance_m, -1.0, 1.0)) <=
                                      reach_rad + std::asin(solid.radius_m / distance_m))
                    tiles_[static_cast<std::size_t>(row * tile_columns_ + column)].push_back(&solid);
            }
        }
}

std::optional<SolidHit> SeenSolids::look(const Ray& ray, int tile_x, int tile_y, double nearest_m) const {
    const SeenSolid* nearest = nullptr;
    for (const SeenSolid* const solid : tiles_[static_cast<std::size_t>(tile_y * tile_columns_ + tile_x)]) {
        const double hit_m = distanceTo(*solid, ray);
        if (hit_m > 0.0 && hit_m < nearest_m) {
            nearest_m = hit_m;
            nearest = solid;
        }
    }
    if (!nearest)
        return std::nullopt;
    const Ray local = inFrameOf(*nearest, ray);
    const Vec3 normal =
        std::visit([&](const auto& shape) { return normalAt(shape, local, nearest_m); }, nearest->shape);
    return SolidHit{nearest_m, nearest->solid_in_map * normal, nearest->color};
}

bool SeenSolids::blocks(const Ray& ray, double maximum_m) const {
    return std::ranges::any_of(all_, [&](const SeenSolid* solid) {
        const double hit_m = distanceTo(*solid, ray);
        return hit_m > 0.0 && hit_m < maximum_m;
    });
}

} // namespace usar::sim
