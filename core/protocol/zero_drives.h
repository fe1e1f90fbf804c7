// The commands that stop a robot of which only its kind is known.
#pragma once

#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

/// The DRIVE of each kind of drive that moves nothing.
inline constexpr AerialDrive no_flight{0.0, 0.0, 0.0, 0.0};
inline constexpr SkidDrive no_spin{0.0, 0.0};
inline constexpr AckermannDrive no_roll{0.0, 0.0, 0.0};
inline constexpr NauticDrive no_thrust{0.0, 0.0, 0.0};

/// Zero DRIVEs for a kind of vehicle. An unknown one (UDK's aerial vehicle does not identify itself as one) gets both
/// that for the air and that for the ground; legged robots and static platforms get none, because they move by their
/// joints.
std::vector<Command> zeroDrives(VehicleKind kind);

} // namespace usar::protocol
