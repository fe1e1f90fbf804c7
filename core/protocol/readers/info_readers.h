// Reading functions for the info messages that do not come from sensors. Each fills all of `out`, which may hold an
// older message. False means that the line stays a GenericMessage: without a diagnostic if it has no data or another
// structure, with one if it is damaged.
#pragma once

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

/// NFO. Start poses and path nodes are refused if one of them is damaged.
bool read(LineReading& line, GameInfo& out);
bool read(LineReading& line, StartPoses& out);
bool read(LineReading& line, PathNodes& out);
bool read(LineReading& line, ClosestPathNode& out);
bool read(LineReading& line, LockstepInfo& out);
/// STA; never refused.
bool read(LineReading& line, RobotState& out);
bool read(LineReading& line, PackageState& out);
/// Refused, like an empty PackageState, if the line has no data.
bool read(LineReading& line, EffecterState& out);
/// STA that answers CONTROL GetSTA. An object without Rotation gets angles of 0.
bool read(LineReading& line, WorldObjects& out);
bool read(LineReading& line, GeometryInfo& out);
bool read(LineReading& line, ConfigurationInfo& out);
/// Refused, with an error, if there is no Status.
bool read(LineReading& line, Response& out);

} // namespace usar::protocol
