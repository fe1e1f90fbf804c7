// The commands that stop a robot of which only its kind is known.
#pragma once

#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

/// Zero DRIVEs for a kind of vehicle. An unknown one (UDK's aerial vehicle does not identify itself as one) gets both
/// that for the air and that for the ground; legged robots and static platforms get none, because they move by their
/// joints.
std::vector<Command> zeroDrives(VehicleKind kind);

} // namespace usar::protocol
