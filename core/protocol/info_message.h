// Everything a server can send, as one variant of small structs, and the line that it came in.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "core/base/cause.h"
#include "core/base/diagnostics.h"
#include "core/base/sealed.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/game_info.h"
#include "core/protocol/info/generic.h"
#include "core/protocol/info/packages.h"
#include "core/protocol/info/robot_state.h"
#include "core/protocol/info/world_objects.h"
#include "core/protocol/sensors/table.h"

namespace usar::protocol {

/// Has no body; used only for its return type.
template <class... Sensors>
std::variant<GenericMessage, GameInfo, StartPoses, PathNodes, ClosestPathNode, LockstepInfo, RobotState, PackageState,
             EffecterState, WorldObjects, GeometryInfo, ConfigurationInfo, Response, Sensors...>
    variantWith(TypeList<Sensors...>);

/// The messages that every server sends, and those of all sensors in the table. GenericMessage is the first one.
using InfoVariant = decltype(variantWith(SensorTypes{}));

/// A message; a variant of all of them.
using InfoMessage = Sealed<InfoVariant>;

/// True if the sensor table has a row for this value of a SEN line's Type, in upper or lower case.
bool isKnownSensor(std::string_view type);

/// False for the types of sensors that send nothing while there is nothing to report (protocol.md 4.5), so that their
/// silence means nothing; true for all others, also for unknown ones. Ignores case. Such a sensor says so in its own
/// struct: `static constexpr bool speaks_always = false`.
bool speaksAlways(std::string_view type);

/// One info line: its number on the connection, its raw text without the line end, its value, and the problems found
/// while reading it.
struct InfoLine {
    LineNumber number;
    std::string text;
    InfoMessage message;
    Diagnostics diagnostics;
};

} // namespace usar::protocol

extern template class usar::Sealed<usar::protocol::InfoVariant>;
