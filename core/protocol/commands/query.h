// Questions about a robot and what it carries.
#pragma once

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// The type under which a server lists the mission packages of a robot. Servers compare it exactly.
inline Token packageType(Dialect dialect) {
    return dialect == Dialect::Udk ? Token("Actuator") : Token("MisPkg");
}

/// GETGEO and GETCONF: `type` is "Robot", "MisPkg", "Actuator" or a type of sensor, effecter or camera; without a name
/// all items of the type are meant.
struct GetGeometry {
    Token type;
    Name name{};
    bool operator==(const GetGeometry&) const = default;
};
struct GetConfiguration {
    Token type;
    Name name{};
    bool operator==(const GetConfiguration&) const = default;
};

} // namespace usar::protocol
