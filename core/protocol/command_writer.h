// Commands to lines, as a client sends them.
#pragma once

#include <string>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// The line without CR LF; keys and values spelled exactly as the servers that compare exactly want them, vectors with
/// commas and no spaces, numbers that read back to the same double. UDK takes the aerial yaw rate in degrees per
/// second. Braces and control characters in names are left out, for nothing can quote them.
std::string write(const Command& command, Dialect dialect = Dialect::Ut2004);

} // namespace usar::protocol
