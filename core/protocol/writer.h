// Converts values to info lines as a UT2004 server sends them, with its spelling, order and decimals, or as a UDK
// server does (protocol.md 7): one line per sensor, with UDK's order and decimals.
#pragma once

#include <string>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::protocol {

/// Appends the line for `message` to `out`, without CR LF. Decimals follow protocol.md 1.7: vectors and the Time
/// of STA and RangeScanner have 2 decimals; formatted floats have 4, truncated toward zero. Angles of INS and
/// GroundTruth are in [0, 2 pi); the battery is in whole seconds, rounded down. A Setting without text is written as
/// its number. Reading the line gives the value back to within those decimals.
void write(const InfoMessage& message, std::string& out);

/// What UDK's lines tell of the robot that they come from.
struct UdkRobot {
    std::string class_name;    ///< the chassis as a mount
    bool steers_front = false; ///< by angles of its wheels, as a car does
    bool steers_rear = false;
};

/// Appends the lines for `message`, each with CR LF. Appends nothing if UDK sends nothing: for results of SET and for
/// answers about things that do not exist. `now` is the Time of messages without one, except of the INS, which never
/// has a Time.
void writeUdk(const InfoMessage& message, Seconds now, const UdkRobot& robot, std::string& out);

} // namespace usar::protocol
