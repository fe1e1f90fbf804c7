// Angles that UDK wants in degrees, without losing a bit of the radians.
#pragma once

#include <string>
#include <string_view>

namespace usar::protocol {

/// Appends degrees that `radiansOfDegrees` turns into exactly this angle: the shortest such double where there is one,
/// else some digits more (where long double is no longer than double, the last bit may differ). No allocation but for
/// `out` itself.
void appendDegrees(std::string& out, double angle_rad);

/// Of a text that is a number by readNumberPrefix; 0 for a number that is not finite.
double radiansOfDegrees(std::string_view number);

} // namespace usar::protocol
