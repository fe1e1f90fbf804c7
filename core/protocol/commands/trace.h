// TRACE: marks on the ground behind the robot; UT2004 only.
#pragma once

#include <optional>

#include "core/base/clock.h"

namespace usar::protocol {

enum class TraceColor { Red, Yellow, Green, Cyan, White, Blue, Purple };

struct Trace {
    bool on = true;
    std::optional<Seconds> interval{}; ///< between marks, while the robot moves
    std::optional<TraceColor> color{};
    bool operator==(const Trace&) const = default;
};

} // namespace usar::protocol
