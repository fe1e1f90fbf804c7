// Converts angles between our radians and the degrees that UDK expects, without losing a bit.
#pragma once

#include <string>
#include <string_view>

namespace usar::protocol {

/// Appends degrees that `radiansOfDegrees` converts back to exactly this angle: the shortest text of a double if one
/// does, otherwise more digits (on platforms whose long double is no longer than double, the last bit may differ).
/// Allocates nothing except in `out` itself. `angle_rad` is finite.
void appendDegrees(std::string& out, double angle_rad);

/// Converts a number in degrees, a text that readNumberPrefix accepts as a whole, to rad; 0 if it is not finite.
double radiansOfDegrees(std::string_view number);

} // namespace usar::protocol
