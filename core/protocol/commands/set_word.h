// What all SET commands share.
#pragma once

#include "core/protocol/commands/description.h"

namespace usar::protocol {

inline constexpr CommandWord set_word{"SET", "sets a sensor, effecter, camera, view or joint",
                                      "SET {Type Odometry} {Name Odometry} {Opcode RESET}"};

inline constexpr Key set_type{"Type", "the type of sensor or effecter"};
inline constexpr Key set_name{"Name", "the item"};
inline constexpr Key set_opcode{"Opcode", "what to do"};

} // namespace usar::protocol
