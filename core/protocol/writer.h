// Values to info lines, as a server sends them (UT2004 spelling, order and decimals; without CR LF).
#pragma once

#include <string>

#include "core/protocol/info_message.h"

namespace usar::protocol {

/// Appends the line for `message` to `out`. Decimals follow usarsim-protocol 1.7: vectors and the Time of STA and
/// RangeScanner with 2 decimals, formatted floats with 4 and cut toward zero; angles of INS and GroundTruth in
/// [0, 2 pi); a battery in whole seconds, rounded down. A Setting without text is written as its number. Reading the
/// line gives the value again within those decimals.
void write(const InfoMessage& message, std::string& out);

} // namespace usar::protocol
