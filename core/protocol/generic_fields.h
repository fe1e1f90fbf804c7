// Lists the values of a message of unknown type: numbers as numbers, vectors by axis, everything else as text.
#pragma once

#include <span>
#include <vector>

#include "core/protocol/fields.h"

namespace usar::protocol {

/// Lists all values except Type and Time. Follows the grouping rule of protocol.md 1.4: a segment belongs to the
/// last group-opening key before it (Name, then Link, ID, PartName, Object, WheelNumber or ViewportN within it), which
/// gives the item its name: "CameraPanTilt Link 1". Values stay in the wire's frame and units.
std::vector<Field> genericFieldsOf(const GenericMessage& message);

/// Statistics of the finite values of a list; all three are NaN if there are none.
struct ListSummary {
    double minimum = 0.0;
    double mean = 0.0;
    double maximum = 0.0;
};
ListSummary summaryOf(std::span<const double> values);

} // namespace usar::protocol
