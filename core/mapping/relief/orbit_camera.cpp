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

OrbitCamera OrbitCamera::showing(std::span<const Vec3> points_in_map_m, double width_by_height,
                                 double exaggeration) const {
    if (points_in_map_m.empty())
        return *this;
    const Vec3 forward = forwardOf(*this);
    const Vec3 right(std::sin(yaw_rad), -std::cos(yaw_rad), 0.0);
    const Vec3 up = right.cross(forward);
    const double tall = std::tan(field_of_view_rad / 2.0) / 1.08; // with a border
    const double wide = tall * width_by_height;
    // Each edge of the picture is a plane through the eye, and each plane must be outside of the farthest point: first
    // for the planes on the left and right, then for those at the top and bottom; the eye is as far back as both need.
    double left_m = -1e30, right_m = -1e30, low_m = -1e30, high_m = -1e30, nearest_m = 1e30;
    for (const Vec3& point : points_in_map_m) {
        const Vec3 drawn(point.x(), point.y(), point.z() * exaggeration);
        const double x = drawn.dot(right), y = drawn.dot(up), z = drawn.dot(forward);
        left_m = std::max(left_m, -x - wide * z);
        right_m = std::max(right_m, x - wide * z);
        low_m = std::max(low_m, -y - tall * z);
        high_m = std::max(high_m, y - tall * z);
        nearest_m = std::min(nearest_m, z);
    }
    const double eye_z = -std::max((left_m + right_m) / (2.0 * wide), (low_m + high_m) / (2.0 * tall));
    // The target is as deep as the middle of the points, whose nearest one is in front of the eye.
    double farthest_m = nearest_m;
    for (const Vec3& point : points_in_map_m)
        farthest_m = std::max(farthest_m, Vec3(point.x(), point.y(), point.z() * exaggeration).dot(forward));
    OrbitCamera camera = *this;
    camera.distance_m = std::clamp((nearest_m + farthest_m) / 2.0 - eye_z, least_distance_m, greatest_distance_m);
    const Vec3 target =
        right * ((right_m - left_m) / 2.0) + up * ((high_m - low_m) / 2.0) + forward * ((nearest_m + farthest_m) / 2.0);
    camera.target_in_map_m = {target.x(), target.y(), target.z() / exaggeration};
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
