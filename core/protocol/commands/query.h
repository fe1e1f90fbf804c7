// Queries about a robot and its equipment.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>

#include "core/base/text.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"

namespace usar::protocol {

/// Everything that can be asked about: Robot, MisPkg, Actuator, the types of all sensors in sensors/table.h, and the
/// other equipment of a robot.
std::span<const std::string_view> askedTypes();

/// The segments of both questions. Corrects the case of the words for the robot and its packages, because UDK compares
/// them case-sensitively.
template <class Io, class Question>
void questionSegments(Io& io, Question& question) {
    if constexpr (Io::writing) {
        constexpr auto exact = texts("Robot", "MisPkg", "Actuator");
        const auto found =
            std::ranges::find_if(exact, [&](std::string_view word) { return sameWord(word, question.type.text()); });
        io.mark("Type", found == exact.end() ? std::string_view(question.type) : *found);
    } else {
        io.text({"Type", "Robot, MisPkg, Actuator or a type of sensor", askedTypes()}, question.type);
    }
    io.text({"Name", "one item; without it all of the type"}, question.name);
}

/// GETGEO: asks for dimensions and mounting poses; the answer is GeometryInfo. `type` is "Robot", "MisPkg", "Actuator"
/// or a type of sensor, effecter or camera; an empty name means all items of the type.
/// On the wire: `GETGEO {Type Sonar}`.
struct GetGeometry {
    Token type;
    Name name{};
    bool operator==(const GetGeometry&) const = default;

    static constexpr CommandWord word{"GETGEO", "asks for sizes and places", "GETGEO {Type Sonar}"};
    static void segments(auto& io, auto& get) { questionSegments(io, get); }
};
/// GETCONF: asks for limits and settings in the same way; the answer is ConfigurationInfo.
/// On the wire: `GETCONF {Type Camera} {Name Cam}`.
struct GetConfiguration {
    Token type;
    Name name{};
    bool operator==(const GetConfiguration&) const = default;

    static constexpr CommandWord word{"GETCONF", "asks for limits and settings", "GETCONF {Type Robot}"};
    static void segments(auto& io, auto& get) { questionSegments(io, get); }
};

} // namespace usar::protocol
