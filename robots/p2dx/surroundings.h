// What lies around the robot, by its newest scan and sonar echoes.
#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/sensors/range_scan.h"
#include "core/protocol/sensors/sonar.h"
#include "robots/p2dx/settings.h"

namespace usar::p2dx {

/// Of the scan, as the thesis cuts it.
enum class Third { Right, Ahead, Left };

/// Where the robot may not go although nothing stands there: it stays in `area_in_map`, unless that is empty.
struct Fence {
    Rectangle area_in_map;
    Vec2 robot_in_map_m = Vec2::Zero();
    double yaw_rad = 0.0;

    /// From the robot to the fence in a direction of its own frame; nothing at all toward the outside when it is there.
    double distance_m(double angle_rad) const;
};

/// Distances in metres. What was not measured is far away.
struct Surroundings {
    static constexpr double far_m = 100.0;

    std::array<double, 3> mean_m{}; ///< of the ranges in each Third
    double ahead_m = far_m;         ///< from the scanner to what is nearest in the strip ahead, along the strip
    double left_m = far_m;          ///< nearest on each side
    double right_m = far_m;
    double low_ahead_m = far_m; ///< least echo of the front sonars; a level floor returns one from 0.9 m

    double meanOf(Third third) const { return mean_m[static_cast<std::size_t>(third)]; }
    /// The third with the greatest mean; ties go to ahead, then to the left.
    Third mostOpen() const;
    /// Away from the nearer side; where neither is clearly nearer, to the more open one.
    bool betterToTheLeft() const;
};

Surroundings look(const protocol::RangeScan& scan, const std::vector<protocol::NamedRange>& sonars, const Fence& fence,
                  const Settings& settings);

} // namespace usar::p2dx
