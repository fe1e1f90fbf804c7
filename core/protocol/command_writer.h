// Commands to lines, as a client sends them.
#pragma once

#include <string>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// Appends the line without CR LF; keys and values spelled exactly as the servers that compare exactly want them,
/// numbers that read back to the same double. UDK takes the aerial yaw rate in degrees per second and an Ackermann
/// DRIVE only whole. Reading the line in the same dialect gives the command again; angles of poses come back within
/// (-pi, pi]. Allocates nothing while `out` has room.
void write(const Command& command, Dialect dialect, std::string& out);
std::string write(const Command& command, Dialect dialect = Dialect::Ut2004);

} // namespace usar::protocol
