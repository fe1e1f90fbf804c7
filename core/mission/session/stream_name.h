// The kind of a message, in the words of the wire.
#pragma once

#include <string>

#include "core/protocol/info_message.h"

namespace usar::mission {

/// Returns "STA", "SEN Sonar", "GEO" …; for a message of an unknown type, its type word and Type.
std::string streamName(const protocol::InfoMessage& message);

/// True if the message comes from the robot itself (STA or SEN) and not from the server about its game.
bool isRobotData(const protocol::InfoMessage& message);

} // namespace usar::mission
