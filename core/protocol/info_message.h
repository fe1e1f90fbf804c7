// Everything a server can tell, as one variant of small structs, and the line that it came in.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/base/alternatives.h"
#include "core/base/cause.h"
#include "core/base/diagnostics.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/game_info.h"
#include "core/protocol/info/generic.h"
#include "core/protocol/info/packages.h"
#include "core/protocol/info/robot_state.h"
#include "core/protocol/info/world_objects.h"
#include "core/protocol/sensors/table.h"

namespace usar::protocol {

template <class... Sensors>
std::variant<GenericMessage, GameInfo, StartPoses, PathNodes, ClosestPathNode, LockstepInfo, RobotState, PackageState,
             EffecterState, WorldObjects, GeometryInfo, ConfigurationInfo, Response, Sensors...>
    variantWith(TypeList<Sensors...>);

/// What every server says, and the sensors of the table.
using InfoVariant = decltype(variantWith(SensorTypes{}));

/// The variant, to be used as one. Copying forty alternatives takes the compiler many seconds, so it is done in one
/// place and not wherever a message is kept.
class InfoMessage : public InfoVariant {
public:
    InfoMessage();
    InfoMessage(const InfoMessage& other);
    InfoMessage(InfoMessage&& other) noexcept;
    InfoMessage& operator=(const InfoMessage& other);
    InfoMessage& operator=(InfoMessage&& other) noexcept;
    ~InfoMessage();

    /// One of the alternatives.
    template <AlternativeOf<InfoVariant> Message>
    InfoMessage(Message&& message)
        : InfoVariant(std::in_place_type<std::decay_t<Message>>, std::forward<Message>(message)) {}

    bool operator==(const InfoMessage& other) const;
    /// The variant has one that its alternatives have not, and meta types ask for it.
    friend bool operator<(const InfoMessage&, const InfoMessage&) = delete;
};

/// Whether the table has a row for a Type of SEN, in any case.
bool isKnownSensor(std::string_view type);

/// One info line: its number on the connection, its raw text, its value, and what was wrong with it.
struct InfoLine {
    LineNumber number;
    std::string text;
    InfoMessage message;
    Diagnostics diagnostics;
};

} // namespace usar::protocol
