// Cause ids: which line said it, and what made us answer. The recording stores both; why-traces and provenance of a
// map cell stand on them.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace usar {

/// Sequence number of an info line on its connection, given when the line is read; the first line is 1, 0 is "none".
struct LineNumber {
    std::uint64_t value = 0;
    auto operator<=>(const LineNumber&) const = default;
};

/// Why a command was sent: who decided (behavior and state, plan node, or "operator", "session") and on which line.
struct Cause {
    std::string source;
    LineNumber trigger;
    bool operator==(const Cause&) const = default;
};

} // namespace usar
