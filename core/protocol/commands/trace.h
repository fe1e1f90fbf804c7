// TRACE: makes the robot leave marks on the ground; UT2004 only.
#pragma once

#include <optional>

#include "core/base/clock.h"

namespace usar::protocol {

enum class TraceColor { Red, Yellow, Green, Cyan, White, Blue, Purple };

/// Absent values keep the settings of the previous TRACE.
/// On the wire: `TRACE {On true} {Interval 0.5} {Color Red}`.
struct Trace {
    bool on = true;
    std::optional<Seconds> interval{}; ///< time between marks while the robot moves
    std::optional<TraceColor> color{};
    bool operator==(const Trace&) const = default;
};

} // namespace usar::protocol
