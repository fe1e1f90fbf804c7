// Heights along a line, for the terrain below the robot or below a measuring tool.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// One point of a profile.
struct ProfilePoint {
    double distance_m = 0.0;       ///< from the start of the line
    std::optional<float> height_m; ///< from the map's array; absent if unknown
    bool operator==(const ProfilePoint&) const = default;
};

/// Evenly spaced points along the straight line between two points of the map frame, including both ends, at most one
/// cell apart; at least two and at most 100 001. Empty if an end is not finite.
std::vector<ProfilePoint> heightProfile(const HeightMap& map, const Vec2& start_m, const Vec2& end_m);

/// The ground along a robot's course. Distances are measured from the robot; those behind it are negative.
struct CourseProfile {
    std::vector<ProfilePoint> points; ///< from `-reach_m` to `reach_m`
    double reach_m = 0.0;
    double robot_z_m = 0.0; ///< height of the robot's base above the same datum as the heights
    bool operator==(const CourseProfile&) const = default;

    /// The known height nearest to the robot, within two meters of it; nullopt if there is none.
    std::optional<double> groundBelow_m() const;
};

/// The profile along the yaw of `base_in_map`. It has no points if the pose is not finite.
CourseProfile courseProfile(const HeightMap& map, const Pose& base_in_map, double reach_m);

} // namespace usar::mapping
