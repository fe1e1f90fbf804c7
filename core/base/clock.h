// Durations and moments on the protocol's clock. No layer below `link` reads a clock: time is passed as an argument.
#pragma once

#include <chrono>

namespace usar {

/// A duration, or a moment counted from the server's own zero. Fractional, because servers send fractions of a second.
using Seconds = std::chrono::duration<double>;

/// Whole milliseconds, truncated toward zero.
inline std::chrono::milliseconds toMilliseconds(Seconds seconds) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(seconds);
}

} // namespace usar
