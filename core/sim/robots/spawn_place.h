// Where a robot can be put when it is told to appear at a pose.
#pragma once

#include <optional>

#include "core/sim/robots/robot.h"

namespace usar::sim {

/// Below this height over something solid a spawned robot will settle on it.
inline constexpr double near_ground_m = 1.0;

/// Distance down to the world's still parts; 2 m at most.
double heightOverGround_m(const RobotSurroundings& surroundings, const Vec3& position_m);

/// `wanted`, level and raised out of the ground by up to a meter. Where another robot is, the nearest place beside it,
/// 2 to 4 m away, as high over the ground and under a sky as open. Nothing where there is no room.
std::optional<Pose> freePose(const RobotSurroundings& surroundings, const BodyDescription& body, const Pose& wanted);

} // namespace usar::sim
