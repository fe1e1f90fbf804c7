#include "core/base/geometry.h"

#include <algorithm>

namespace usar {

double normalizedAngle(double angle_rad) {
    const double wrapped = std::remainder(angle_rad, 2.0 * pi);
    return wrapped <= -pi ? wrapped + 2.0 * pi : wrapped;
}

Eigen::Quaterniond Pose::rotation() const {
    using Eigen::AngleAxisd;
    return AngleAxisd(yaw_rad, Vec3::UnitZ()) * AngleAxisd(pitch_rad, Vec3::UnitY()) *
           AngleAxisd(roll_rad, Vec3::UnitX());
}

Eigen::Isometry3d Pose::isometry() const {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = rotation().toRotationMatrix();
    result.translation() = position_m;
    return result;
}

Pose Pose::from(const Eigen::Isometry3d& isometry) {
    const auto& r = isometry.linear();
    return {isometry.translation(), std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
            std::atan2(r(1, 0), r(0, 0))};
}

Pose Pose::from(const Vec3& position_m, const Eigen::Quaterniond& rotation) {
    Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
    isometry.linear() = rotation.normalized().toRotationMatrix();
    isometry.translation() = position_m;
    return from(isometry);
}

Pose operator*(const Pose& b_in_a, const Pose& c_in_b) {
    return Pose::from(b_in_a.isometry() * c_in_b.isometry());
}

Vec3 operator*(const Pose& b_in_a, const Vec3& point_in_b_m) {
    return b_in_a.rotation() * point_in_b_m + b_in_a.position_m;
}

Pose inverse(const Pose& b_in_a) {
    return Pose::from(b_in_a.isometry().inverse());
}

} // namespace usar
