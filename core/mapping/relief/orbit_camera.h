// A camera that orbits around a point of the map, and its perspective.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry.h"

namespace usar::mapping {

/// Where the map is seen from. The picture has no roll: what is higher is nearer to its upper edge.
struct OrbitCamera {
    static constexpr double lowest_elevation_rad = radians(5.0); ///< from lower down, hills would hide everything
    static constexpr double highest_elevation_rad = radians(90.0);
    static constexpr double least_distance_m = 1.0;
    static constexpr double greatest_distance_m = 20000.0;

    Vec3 target_in_map_m = Vec3::Zero(); ///< in the middle of the picture
    double yaw_rad = pi / 2; ///< where it looks, counterclockwise from x; with pi / 2, y is up in the picture
    double elevation_rad = radians(35.0); ///< above the horizon, as seen from the target
    double distance_m = 100.0;
    double field_of_view_rad = radians(40.0); ///< vertical

    /// The nearest permitted camera; not-a-number becomes a usual value.
    OrbitCamera limited() const;
    /// The same direction of view, moved so that these points fill a picture of this shape, with a small border; no
    /// points change nothing.
    OrbitCamera showing(std::span<const Vec3> points_in_map_m, double width_by_height, double exaggeration = 1.0) const;
    bool operator==(const OrbitCamera&) const = default;
};

/// A point in a picture. Pixel (0, 0) is the upper left one, with its center at (0.5, 0.5).
struct PicturePoint {
    double x_px = 0.0;
    double y_px = 0.0;
    double nearness_per_m = 0.0; ///< one by the distance along the direction of view
};

/// Perspective of a camera for a picture of a size. Heights are drawn `exaggeration` times as high as they are.
class ReliefProjection {
public:
    /// Nothing nearer to the camera is drawn.
    static constexpr double nearest_m = 0.2;

    ReliefProjection(const OrbitCamera& camera, int width_px, int height_px, double exaggeration = 1.0);

    /// To the right, up and forward from the camera, in meters of the drawn space.
    Vec3 toCamera(const Vec3& point_in_map_m) const;
    /// nullopt behind the camera, or nearer than `nearest_m`; the point may be beside the picture.
    std::optional<PicturePoint> project(const Vec3& point_in_map_m) const;
    /// The reverse of project().
    Vec3 unproject(const PicturePoint& point) const;
    /// The point of a level plane that is seen at a place of the picture; nullopt above the horizon.
    std::optional<Vec3> onPlane(double x_px, double y_px, double height_m) const;

    double focal_px() const { return focal_px_; } ///< size in pixels of one meter at a distance of one meter
    Vec3 eye_in_map_m() const;
    double exaggeration() const { return exaggeration_; }
    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }

private:
    Eigen::Matrix3d to_camera_; ///< rows: to the right, up, forward
    Vec3 eye_drawn_m_;
    double focal_px_;
    double exaggeration_;
    int width_px_;
    int height_px_;
};

} // namespace usar::mapping
