#include "core/mapping/relief/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace usar::mapping {

namespace {

Vec3 forwardOf(const OrbitCamera& camera) {
    const double level = std::cos(camera.elevation_rad);
    return {level * std::cos(camera.yaw_rad), level * std::sin(camera.yaw_rad), -std::sin(camera.elevation_rad)};
}

} // namespace

OrbitCamera OrbitCamera::limited() const {
    const OrbitCamera usual;
    const auto within = [](double value, double low, double high, double otherwise) {
        return std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
    };
    OrbitCamera camera = *this;
    if (!target_in_map_m.allFinite())
        camera.target_in_map_m = usual.target_in_map_m;
    camera.yaw_rad = std::isfinite(yaw_rad) ? normalizedAngle(yaw_rad) : usual.yaw_rad;
    camera.elevation_rad = within(elevation_rad, lowest_elevation_rad, highest_elevation_rad, usual.elevation_rad);
    camera.distance_m = within(distance_m, least_distance_m, greatest_distance_m, usual.distance_m);
    camera.field_of_view_rad = within(field_of_view_rad, radians(5.0), radians(120.0), usual.field_of_view_rad);
    return camera;
}

OrbitCamera OrbitCamera::showing(const Rectangle& area_in_map, double middle_height_m, double width_by_height) const {
    OrbitCamera camera = *this;
    const Vec2 center_m = area_in_map.center_m();
    camera.target_in_map_m = {center_m.x(), center_m.y(), middle_height_m};
    const double tangent = std::tan(field_of_view_rad / 2.0);
    const Vec3 right(std::sin(yaw_rad), -std::cos(yaw_rad), 0.0);
    const Vec3 forward = forwardOf(camera);
    const Vec3 up = right.cross(forward);
    camera.distance_m = least_distance_m;
    for (const double x_m : {area_in_map.min_m.x(), area_in_map.max_m.x()})
        for (const double y_m : {area_in_map.min_m.y(), area_in_map.max_m.y()}) {
            const Vec3 from_center_m(x_m - center_m.x(), y_m - center_m.y(), 0.0);
            const double wide_m =
                std::max(std::abs(from_center_m.dot(right)) / width_by_height, std::abs(from_center_m.dot(up)));
            constexpr double with_a_border = 1.08;
            camera.distance_m =
                std::max(camera.distance_m, with_a_border * wide_m / tangent - from_center_m.dot(forward));
        }
    return camera.limited();
}

ReliefProjection::ReliefProjection(const OrbitCamera& camera, int width_px, int height_px, double exaggeration)
    : focal_px_(height_px / 2.0 / std::tan(camera.field_of_view_rad / 2.0))
    , exaggeration_(exaggeration)
    , width_px_(width_px)
    , height_px_(height_px) {
    const Vec3 forward = forwardOf(camera);
    const Vec3 right(std::sin(camera.yaw_rad), -std::cos(camera.yaw_rad), 0.0);
    to_camera_ << right.transpose(), right.cross(forward).transpose(), forward.transpose();
    const Vec3 target_drawn_m(camera.target_in_map_m.cwiseProduct(Vec3(1.0, 1.0, exaggeration)));
    eye_drawn_m_ = target_drawn_m - camera.distance_m * forward;
}

Vec3 ReliefProjection::toCamera(const Vec3& point_in_map_m) const {
    return to_camera_ * (point_in_map_m.cwiseProduct(Vec3(1.0, 1.0, exaggeration_)) - eye_drawn_m_);
}

std::optional<PicturePoint> ReliefProjection::project(const Vec3& point_in_map_m) const {
    const Vec3 at_m = toCamera(point_in_map_m);
    if (!(at_m.z() >= nearest_m)) // This is also true for NaN.
        return std::nullopt;
    return PicturePoint{width_px_ / 2.0 + focal_px_ * at_m.x() / at_m.z(),
                        height_px_ / 2.0 - focal_px_ * at_m.y() / at_m.z(), 1.0 / at_m.z()};
}

Vec3 ReliefProjection::unproject(const PicturePoint& point) const {
    const double depth_m = 1.0 / point.nearness_per_m;
    const Vec3 at_m((point.x_px - width_px_ / 2.0) / focal_px_ * depth_m,
                    (height_px_ / 2.0 - point.y_px) / focal_px_ * depth_m, depth_m);
    const Vec3 drawn_m = to_camera_.transpose() * at_m + eye_drawn_m_;
    return drawn_m.cwiseQuotient(Vec3(1.0, 1.0, exaggeration_));
}

std::optional<Vec3> ReliefProjection::onPlane(double x_px, double y_px, double height_m) const {
    const Vec3 way =
        to_camera_.transpose() * Vec3((x_px - width_px_ / 2.0) / focal_px_, (height_px_ / 2.0 - y_px) / focal_px_, 1.0);
    const double rise_m = height_m * exaggeration_ - eye_drawn_m_.z();
    const double steps = rise_m / way.z();
    if (!(steps > 0.0) || !(steps < OrbitCamera::greatest_distance_m * 10.0))
        return std::nullopt;
    const Vec3 drawn_m = eye_drawn_m_ + steps * way;
    return Vec3(drawn_m.x(), drawn_m.y(), height_m);
}

Vec3 ReliefProjection::eye_in_map_m() const {
    return eye_drawn_m_.cwiseQuotient(Vec3(1.0, 1.0, exaggeration_));
}

} // namespace usar::mapping
