// What a faulty sensor tells instead of the truth.
#pragma once

#include "core/protocol/info_message.h"
#include "core/sim/faults/fault.h"

namespace usar::sim {

/// A bias: `by` on every number of the message with a unit of its own, x, y, z and yaw_deg on positions and
/// orientations. Texts, counts, yes and no, and times stay.
void addBias(const Fault& bias, protocol::InfoMessage& message);

/// The message of a frozen sensor, said again now.
void sayAgain(Seconds now, protocol::InfoMessage& frozen);

/// Puts a line of one sensor behind the others, into the line of its type where that is the last one there.
void addLine(protocol::InfoMessage&& message, std::vector<protocol::InfoMessage>& out);

} // namespace usar::sim
