// What kind of message a line is, in the words of the wire.
#pragma once

#include <string>

#include "core/protocol/info_message.h"

namespace usar::mission {

/// "STA", "SEN Sonar", "GEO" …; for a line that no table knows its type word and Type.
std::string streamName(const protocol::InfoMessage& message);

/// The robot itself speaks: STA or SEN, in contrast to what the server says about its game.
bool isRobotData(const protocol::InfoMessage& message);

} // namespace usar::mission
