// Command lines to values, as a server takes them.
#pragma once

#include <string_view>

#include "core/base/diagnostics.h"
#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// As tolerant as usarsim-protocol 1.2-1.7: any case, any spacing, vectors with commas or spaces, prefix numbers
/// (`1,00` is 1, a word is 0, as servers take them), the aliases STARTPOSES and MISSPKG. What no struct of command.h
/// can hold comes back as RawCommand with the whole line. Never fails; `diagnostics` says what was mended or why a line
/// stayed raw. `dialect` decides the unit of the aerial yaw rate: radians per second, degrees in UDK.
Command readCommand(std::string_view line, Diagnostics& diagnostics, Dialect dialect = Dialect::Ut2004);

} // namespace usar::protocol
