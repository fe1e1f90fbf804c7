// Values to info lines as a UDK server sends them (usarsim-protocol 7): one line a sensor, its own order and decimals.
#pragma once

#include <string>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::protocol {

/// Appends the lines for `message`, each with CR LF, and none where UDK says nothing: results of SET, answers about
/// what is not there. `now` is the Time of what brings none, but for the INS, which never has one. `robot_class` is
/// what UDK calls the chassis as a mount.
void writeUdk(const InfoMessage& message, Seconds now, const std::string& robot_class, std::string& out);

} // namespace usar::protocol
