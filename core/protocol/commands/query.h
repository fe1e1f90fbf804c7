// Queries about a robot and its equipment.
#pragma once

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// The type under which a server lists the mission packages of a robot. Servers compare it case-sensitively.
inline Token packageType(Dialect dialect) {
    return dialect == Dialect::Udk ? Token("Actuator") : Token("MisPkg");
}

/// GETGEO: asks for dimensions and mounting poses; the answer is GeometryInfo. `type` is "Robot", "MisPkg", "Actuator"
/// or a type of sensor, effecter or camera; an empty name means all items of the type.
/// On the wire: `GETGEO {Type Sonar}`.
struct GetGeometry {
    Token type;
    Name name{};
    bool operator==(const GetGeometry&) const = default;
};
/// GETCONF: asks for limits and settings in the same way; the answer is ConfigurationInfo.
/// On the wire: `GETCONF {Type Camera} {Name Cam}`.
struct GetConfiguration {
    Token type;
    Name name{};
    bool operator==(const GetConfiguration&) const = default;
};

} // namespace usar::protocol
