// Lists the values of a message of unknown type: numbers as numbers, vectors by axis, everything else as text.
#pragma once

#include <vector>

#include "core/protocol/fields.h"

namespace usar::protocol {

/// Lists all values except Type and Time. Follows the grouping rule of protocol.md 1.4: a segment belongs to the
/// last group-opening key before it (Name, then Link, ID, PartName, Object, WheelNumber or ViewportN within it), which
/// gives the item its name: "CameraPanTilt Link 1". Values stay in the wire's frame and units.
std::vector<Field> genericFieldsOf(const GenericMessage& message);

} // namespace usar::protocol
