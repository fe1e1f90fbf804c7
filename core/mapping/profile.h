// Heights along a line: the terrain under the robot, or under a ruler.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

struct ProfilePoint {
    double distance_m = 0.0;       ///< from the start of the line
    std::optional<float> height_m; ///< the array's; absent where nothing is known
    bool operator==(const ProfilePoint&) const = default;
};

/// Evenly spread points along the straight line, at most a cell apart, ends included; at least two and at most
/// 100 001. Ends that are not finite give none.
std::vector<ProfilePoint> heightProfile(const HeightMap& map, const Vec2& start_m, const Vec2& end_m);

/// The ground along a robot's course. Distances count from the robot, negative ones lie behind it.
struct CourseProfile {
    std::vector<ProfilePoint> points; ///< from `-reach_m` to `reach_m`
    double reach_m = 0.0;
    double robot_z_m = 0.0; ///< of the robot's base, by the same datum as the heights
    bool operator==(const CourseProfile&) const = default;

    /// The nearest known height to the robot within two metres of it; nothing where the map is empty there.
    std::optional<double> groundBelow_m() const;
};

/// Along the yaw of `base_in_map`. A pose that is not finite gives no points.
CourseProfile courseProfile(const HeightMap& map, const Pose& base_in_map, double reach_m);

} // namespace usar::mapping
