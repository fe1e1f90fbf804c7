// Points, angles, poses and rectangles. Frames follow REP-103: right-handed, x forward, y left, z up, yaw
// counterclockwise seen from above. A pose is named <what>_in_<frame>, so that the frames in a product match up like
// dominoes: `sonar_in_map = base_in_map * sonar_in_base`.
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace usar {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

inline constexpr double pi = std::numbers::pi;

constexpr double radians(double degrees) {
    return degrees * pi / 180.0;
}
constexpr double degrees(double radians_) {
    return radians_ * 180.0 / pi;
}

/// Returns the equivalent angle in (-pi, pi]; NaN stays NaN.
double normalizedAngle(double angle_rad);

/// Direction of `vector` in rad, in [-pi, pi], measured from the x axis toward the y axis; 0 for the zero vector.
inline double bearingOf(const Vec2& vector) {
    return std::atan2(vector.y(), vector.x());
}

/// Position and attitude of one frame in another. The attitude is yaw about z, then pitch about y, then roll about x (R
/// = Rz Ry Rx); by the right-hand rule a positive pitch lowers the nose.
struct Pose {
    Vec3 position_m = Vec3::Zero();
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    double yaw_rad = 0.0;

    /// The rotation that turns vectors of the posed frame into the reference frame.
    Eigen::Quaterniond rotation() const;
    /// The transform of points of the posed frame into the reference frame.
    Eigen::Isometry3d isometry() const;
    /// Angles come out with pitch in [-pi/2, pi/2], roll and yaw in [-pi, pi].
    static Pose from(const Eigen::Isometry3d& isometry);
    /// `rotation` need not be normalized, but must not be zero.
    static Pose from(const Vec3& position_m, const Eigen::Quaterniond& rotation);
    bool operator==(const Pose&) const = default;
};

/// Chains two poses: c_in_a = b_in_a * c_in_b.
Pose operator*(const Pose& b_in_a, const Pose& c_in_b);
/// Transforms a point: point_in_a = b_in_a * point_in_b.
Vec3 operator*(const Pose& b_in_a, const Vec3& point_in_b_m);
/// Returns a_in_b.
Pose inverse(const Pose& b_in_a);

/// An axis-aligned rectangle in the map frame. It is empty unless `max` exceeds `min` on both axes. Points on the
/// border are inside.
struct Rectangle {
    Vec2 min_m = Vec2::Zero();
    Vec2 max_m = Vec2::Zero();

    double width_m() const { return max_m.x() - min_m.x(); }
    double height_m() const { return max_m.y() - min_m.y(); }
    /// 0 if the rectangle is empty; width and height may be negative then.
    double area_m2() const { return empty() ? 0.0 : width_m() * height_m(); }
    bool empty() const { return !(width_m() > 0.0 && height_m() > 0.0); }
    Vec2 center_m() const { return (min_m + max_m) / 2.0; }
    bool contains(const Vec2& point_m) const {
        return point_m.x() >= min_m.x() && point_m.x() <= max_m.x() && point_m.y() >= min_m.y() &&
               point_m.y() <= max_m.y();
    }
    bool contains(const Rectangle& other) const { return contains(other.min_m) && contains(other.max_m); }
    bool operator==(const Rectangle&) const = default;
};

} // namespace usar
