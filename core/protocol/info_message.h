// Everything a server can tell, as one variant of small structs, and the line that it came in.
#pragma once

#include <string>
#include <variant>

#include "core/base/cause.h"
#include "core/base/diagnostics.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/game_info.h"
#include "core/protocol/info/generic.h"
#include "core/protocol/info/pose_sensors.h"
#include "core/protocol/info/range_sensors.h"
#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

using InfoMessage =
    std::variant<GenericMessage, GameInfo, StartPoses, LockstepInfo, RobotState, SonarReadings, RangeScan, InsReading,
                 GroundTruthReading, OdometryReading, EncoderReadings, GeometryInfo, ConfigurationInfo, Response>;

/// One info line: its number on the connection, its raw text, its value, and what was wrong with it.
struct InfoLine {
    LineNumber number;
    std::string text;
    InfoMessage message;
    Diagnostics diagnostics;
};

} // namespace usar::protocol
