// Finds a place for a robot that is told to appear at a pose.
#pragma once

#include <optional>

#include "core/sim/robots/robot.h"

namespace usar::sim {

/// A robot spawned less than this above something solid will settle on it.
inline constexpr double near_ground_m = 1.0;

/// Distance down to the fixed parts of the world; at most 2 m.
double heightOverGround_m(const RobotSurroundings& surroundings, const Vec3& position_m);

/// Returns `wanted`, level and raised out of the ground by up to a meter. If another robot is there, the nearest place
/// beside it instead, 2 to 4 m away, at the same height above the ground and under an equally open sky. Returns nullopt
/// if there is no room.
std::optional<Pose> freePose(const RobotSurroundings& surroundings, const BodyDescription& body, const Pose& wanted);

} // namespace usar::sim
