// Values of a message that no table knows: numbers where they are numbers, vectors by axis, the rest as text.
#pragma once

#include <span>
#include <vector>

#include "core/protocol/fields.h"

namespace usar::protocol {

/// Follows the groups of usarsim-protocol 1.4: a segment belongs to the last group-opening key before it (Name, then
/// Link, ID, PartName, Object, WheelNumber, ViewportN within it), which makes the item: "CameraPanTilt Link 1". Values
/// stay in the wire's frame and units.
std::vector<Field> genericFieldsOf(const GenericMessage& message);

/// Of the finite ones; NaN all three where there is none.
struct ListSummary {
    double minimum = 0.0;
    double mean = 0.0;
    double maximum = 0.0;
};
ListSummary summaryOf(std::span<const double> values);

} // namespace usar::protocol
