// Alters the messages of faulty sensors.
#pragma once

#include "core/protocol/info_message.h"
#include "core/sim/faults/fault.h"

namespace usar::sim {

/// Adds a bias: `by` to every number of the message that has a unit of its own; x, y, z and yaw_deg to positions and
/// orientations. Texts, counts, flags and times stay the same.
void addBias(const Fault& bias, protocol::InfoMessage& message);

/// Sets the time of a frozen sensor's message, if it has one, to `now`.
void sayAgain(Seconds now, protocol::InfoMessage& frozen);

/// Appends one sensor's message to `out`, or merges it into the last message there if that has the same type.
void addLine(protocol::InfoMessage&& message, std::vector<protocol::InfoMessage>& out);

} // namespace usar::sim
