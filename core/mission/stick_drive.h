// Turns a person's stick into the DRIVE of a robot, by its kind and by what it was learnt to be able to do.
#pragma once

#include <optional>

#include "core/mission/drive_limits.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// Nobody steers well with more, rad/s: a P2DX could spin ten times a second.
inline constexpr double most_yaw_rate_rad_s = 2.0;

/// The DRIVE for this stick, with every term of its kind, so that nothing that was said before stays in force.
/// `speed_share` (0..1) scales speeds, not the angles of wheels and fins. In physical units where the limit is known,
/// else in per cent of it, which the server knows. A robot on wheels that forward and turn ask too much of together
/// keeps its curve and loses speed. Nothing for what cannot be driven so: an unknown style, and a walker, whose joints
/// need a gait (walking_gait.h).
std::optional<protocol::Command> driveOf(const DriveLimits& limits, const Stick& stick, double speed_share);

} // namespace usar::mission
