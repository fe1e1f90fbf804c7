// Reading functions of the info messages that are no sensor's. Each fills all of `out`, which may hold an older
// message; false means that the line stays a GenericMessage: without a diagnostic where it says nothing or is of
// another shape, with one where it is damaged.
#pragma once

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

bool read(LineReading& line, GameInfo& out);
bool read(LineReading& line, StartPoses& out);
bool read(LineReading& line, PathNodes& out);
bool read(LineReading& line, ClosestPathNode& out);
bool read(LineReading& line, LockstepInfo& out);
bool read(LineReading& line, RobotState& out);
bool read(LineReading& line, PackageState& out);
bool read(LineReading& line, EffecterState& out);
bool read(LineReading& line, WorldObjects& out);
bool read(LineReading& line, GeometryInfo& out);
bool read(LineReading& line, ConfigurationInfo& out);
bool read(LineReading& line, Response& out);

} // namespace usar::protocol
