// Command lines to values, as a server takes them.
#pragma once

#include <string_view>

#include "core/base/diagnostics.h"
#include "core/protocol/command.h"

namespace usar::protocol {

/// As tolerant as usarsim-protocol 1.2-1.7: any case, any spacing, vectors with commas or spaces, prefix numbers,
/// aliases STARTPOSES and MISSPKG. An unknown word comes back as RawCommand. Never fails; `diagnostics` says what was
/// mended. `dialect` decides the unit of the aerial yaw rate.
Command readCommand(std::string_view line, Diagnostics& diagnostics);

} // namespace usar::protocol
