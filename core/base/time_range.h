// Ranges of time until an event, and the time until it as short text: "2:03".
#pragma once

#include <string>

#include "core/base/clock.h"

namespace usar {

/// A range of durations until an event, both from the same moment on.
struct TimeRange {
    Seconds least{0.0};
    Seconds most{0.0};
    bool operator==(const TimeRange&) const = default;
};

/// "2:03" or "1:02:03", rounded up to whole seconds; "0:00" for negative spans.
std::string countdownText(Seconds span);

} // namespace usar
