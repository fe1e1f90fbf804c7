// Rounding that costs little.
#pragma once

#include <cstdint>

namespace usar {

/// The largest whole number that is not above `value`, whose magnitude is below 2^62. std::floor is a call of the C
/// library in code for any 64-bit PC; grids ask a million times a second.
inline std::int64_t wholeBelow(double value) {
    const auto cut = static_cast<std::int64_t>(value);
    return cut - (value < static_cast<double>(cut) ? 1 : 0);
}

} // namespace usar
