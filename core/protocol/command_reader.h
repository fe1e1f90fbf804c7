// Converts command lines to values, as a server does.
#pragma once

#include <string_view>

#include "core/base/diagnostics.h"
#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// Reads one line without its line end, as tolerantly as protocol.md 1.2-1.7 asks: any case, any spacing, vectors
/// with commas or spaces, numbers followed by junk (`1,00` is 1, a word is 0, as servers read them), the aliases
/// STARTPOSES and MISSPKG. A line that no struct of command.h can hold is returned whole as a RawCommand. Never fails;
/// `diagnostics` receives what was corrected, or why a line with a known first word stayed raw. `dialect` decides the
/// unit of the aerial yaw rate: radians per second in UT2004, degrees per second in UDK.
Command readCommand(std::string_view line, Diagnostics& diagnostics, Dialect dialect = Dialect::Ut2004);

} // namespace usar::protocol
