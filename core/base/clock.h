// Durations and moments on the protocol's clock. Nobody below `link` owns a clock: time is an argument.
#pragma once

#include <chrono>

namespace usar {

/// A duration, or a moment counted from the server's own zero. Fractional, because the wire sends fractions.
using Seconds = std::chrono::duration<double>;

inline std::chrono::milliseconds toMilliseconds(Seconds seconds) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(seconds);
}

} // namespace usar
