// Converts values to info lines as a UDK server sends them (protocol.md 7): one line per sensor, with UDK's order
// and decimals.
#pragma once

#include <string>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::protocol {

/// Appends the lines for `message`, each with CR LF. Appends nothing if UDK sends nothing: for results of SET and for
/// answers about things that do not exist. `now` is the Time of messages without one, except of the INS, which never
/// has a Time. `robot_class` is the name that UDK uses for the chassis as a mount.
void writeUdk(const InfoMessage& message, Seconds now, const std::string& robot_class, std::string& out);

} // namespace usar::protocol
