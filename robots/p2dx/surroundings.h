// Distances around the robot, from its newest scan and sonar echoes.
#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/sensors/range_scan.h"
#include "core/protocol/sensors/sonar.h"
#include "robots/p2dx/settings.h"

namespace usar::p2dx {

/// A third of the scan, divided as in the thesis.
enum class Third { Right, Ahead, Left };

/// A virtual fence around the mission area. The robot stays inside `area_in_map`; if that is empty, there is no fence.
struct Fence {
    Rectangle area_in_map;
    Vec2 robot_in_map_m = Vec2::Zero();
    double yaw_rad = 0.0;

    /// Returns the distance from the robot to the fence in a direction of the robot's frame (counterclockwise from
    /// straight ahead); 0 if the robot is outside and the direction leads farther out.
    double distance_m(double angle_rad) const;
};

/// Distances in meters. A distance that was not measured is far_m.
struct Surroundings {
    static constexpr double far_m = 100.0;

    std::array<double, 3> mean_m{}; ///< mean range of each Third
    double ahead_m = far_m; ///< distance from the scanner to the nearest object in the strip ahead, along the strip
    double left_m = far_m;  ///< distance to the nearest object on the left
    double right_m = far_m;
    double low_ahead_m = far_m; ///< shortest echo of the front sonars; a level floor returns one from 0.9 m

    double meanOf(Third third) const { return mean_m[static_cast<std::size_t>(third)]; }
    /// The third with the greatest mean range. On a tie, ahead is preferred to left and left to right.
    Third mostOpen() const;
    /// Returns whether to turn left: away from the nearer side or, if neither side is clearly nearer, to the more open
    /// one.
    bool betterToTheLeft() const;
};

/// Evaluates a scan and the newest echo of each sonar. Beams end at the fence.
Surroundings look(const protocol::RangeScan& scan, const std::vector<protocol::NamedRange>& sonars, const Fence& fence,
                  const Settings& settings);

} // namespace usar::p2dx
