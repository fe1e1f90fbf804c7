// Converts values to info lines as a UT2004 server sends them, with its spelling, order and decimals.
#pragma once

#include <string>

#include "core/protocol/info_message.h"

namespace usar::protocol {

/// Appends the line for `message` to `out`, without CR LF. Decimals follow protocol.md 1.7: vectors and the Time
/// of STA and RangeScanner have 2 decimals; formatted floats have 4, truncated toward zero. Angles of INS and
/// GroundTruth are in [0, 2 pi); the battery is in whole seconds, rounded down. A Setting without text is written as
/// its number. Reading the line gives the value back to within those decimals.
void write(const InfoMessage& message, std::string& out);

} // namespace usar::protocol
