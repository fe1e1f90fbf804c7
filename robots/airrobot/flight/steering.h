// Chooses the direction toward a goal among remembered obstacles, with a polar histogram (VFH) over the obstacle
// memory.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "robots/airrobot/flight/obstacle_memory.h"

namespace usar::airrobot {

/// The free space that a direction must have.
struct WayNeeded {
    double half_width_m = 1.2;
    double length_m = 3.5; ///< less if the goal is nearer
};

/// Prefers its last choice, so that the robot does not alternate between two equal ways around a tree. Owned by one
/// robot.
class Steering {
public:
    /// Returns the open bearing nearest to that of the goal, within 120 degrees to each side; nullopt if all are
    /// blocked. Bearings are in the map frame. Obstacles over which the robot will have climbed on the way there do not
    /// count: an obstacle with a known top blocks only if it is higher than `level_m` (map z) plus half a meter per
    /// meter of distance.
    std::optional<double> choose(std::span<const Obstacle> obstacles, const Vec2& from_m, const Vec2& goal_m,
                                 double level_m, const WayNeeded& needed);
    void reset() { last_rad_.reset(); }

private:
    std::optional<double> last_rad_;
};

/// Returns the greatest speed at which the robot, braking with `braking_m_s2` after `latency_s`, stops within `free_m`
/// (robots-and-worlds.md 7: v <= sqrt(2 a r), extended by the delay of a sense-act cycle).
double stoppingSpeed_m_s(double free_m, double braking_m_s2, double latency_s = 0.4);

} // namespace usar::airrobot
