// Which way to fly toward a goal among what is remembered: a polar histogram (VFH) over the obstacle memory.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "robots/airrobot/obstacle_memory.h"

namespace usar::airrobot {

/// What a direction must offer.
struct WayNeeded {
    double half_width_m = 1.2;
    double length_m = 3.5; ///< or up to the goal, if that is nearer
};

/// Keeps the last choice, so that two equal ways round a tree do not alternate. Owned by one robot.
class Steering {
public:
    /// The open bearing nearest to the goal's, within 120 degrees; nothing if all are blocked. Bearings in the map
    /// frame. Obstacles whose known top the climb on the way will have passed are no obstacle: `level_m` is the lowest
    /// height that blocks here, and rises by half a metre a metre.
    std::optional<double> choose(std::span<const Obstacle> obstacles, const Vec2& from_m, const Vec2& goal_m,
                                 double level_m, const WayNeeded& needed);
    void reset() { last_rad_.reset(); }

private:
    std::optional<double> last_rad_;
};

/// Largest speed at which the robot, braking at `braking_m_s2` after `latency`, stops within `free_m`
/// (robots-and-worlds 7: v <= sqrt(2 a r), with the delay of a sense-act cycle).
double stoppingSpeed_m_s(double free_m, double braking_m_s2, double latency_s = 0.4);

} // namespace usar::airrobot
