// Converts commands to lines, as a client sends them.
#pragma once

#include <string>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// Appends the line without CR LF. Keys and values are spelled exactly as the servers with case-sensitive comparison
/// expect them, and numbers read back as the same double. UDK takes the aerial yaw rate in degrees per second, and an
/// Ackermann DRIVE only if it is complete. Reading the line in the same dialect gives the command back, with the angles
/// of poses in (-pi, pi]. Allocates nothing while `out` has room.
void write(const Command& command, Dialect dialect, std::string& out);
std::string write(const Command& command, Dialect dialect = Dialect::Ut2004);

} // namespace usar::protocol
