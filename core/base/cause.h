// Identifies the info line that carried a fact and the reason why a command was sent. Recordings store both; why-traces
// and the provenance of map cells are built from them.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace usar {

/// Sequence number of an info line on its connection, assigned when the line is read. The first line is 1; 0 means "no
/// line".
struct LineNumber {
    std::uint64_t value = 0;
    auto operator<=>(const LineNumber&) const = default;
};

/// The reason why a command was sent. `source` names who decided: a behavior and its state, a plan node, "operator" or
/// "session". `trigger` is the info line that led to the decision, or 0 if there was none.
struct Cause {
    std::string source;
    LineNumber trigger;
    bool operator==(const Cause&) const = default;
};

} // namespace usar
