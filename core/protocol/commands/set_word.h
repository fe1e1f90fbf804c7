// What all SET commands share.
#pragma once

#include "core/protocol/commands/description.h"

namespace usar::protocol {

inline constexpr CommandWord set_word{"SET", "sets a sensor, effecter, camera, view or joint",
                                      "SET {Type Odometry} {Name Odometry} {Opcode RESET}"};

inline constexpr Key set_type{"Type", "the type of sensor or effecter"};
inline constexpr Key set_name{"Name", "the item"};
inline constexpr Key set_opcode{"Opcode", "what to do"};

/// Passes Type, Name and Opcode, in the order that all clients use.
void setSegments(auto& io, std::string_view type, auto& name, std::string_view opcode) {
    io.mark(set_type, type);
    io.text(set_name, name);
    io.mark(set_opcode, opcode);
}

} // namespace usar::protocol
