// Identifies the info line that carried a fact and the reason why a command was sent. Recordings store both; why-traces
// and the provenance of map cells are built from them.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace usar {

/// Sequence number of an info line on its connection, assigned when the line is read. The first line is 1; 0 means "no
/// line".
struct LineNumber {
    std::uint64_t value = 0;
    auto operator<=>(const LineNumber&) const = default;
};

/// Who decided that a command is sent, and why. Recordings and the window show a source as text.
namespace by {

/// A source of no other kind: "camera".
struct Other {
    std::string name;
    bool operator==(const Other&) const = default;
};
/// A behavior in a state: "airrobot/cpp: scanning lane 4". The id is empty until the behavior's host has added it.
struct Behavior {
    std::string behavior_id;
    std::string state;
    bool operator==(const Behavior&) const = default;
};
/// A behavior's plan. `path` has the names of the nodes down to the act; `why` is the act's own reason and may be
/// empty: "p2dx/posh: rover ▸ work ▸ drive: around the corner". The id is empty as in `Behavior`.
struct Plan {
    std::string behavior_id;
    std::string path;
    std::string why;
    bool operator==(const Plan&) const = default;
};
/// The user's hand on an input device: "by hand: keys".
struct Hand {
    std::string what;
    bool operator==(const Hand&) const = default;
};
/// The session itself: "session: spawn".
struct Session {
    std::string why;
    bool operator==(const Session&) const = default;
};
/// The user's order in the window: "operator: stop".
struct Operator {
    std::string what;
    bool operator==(const Operator&) const = default;
};

using Source = std::variant<Other, Behavior, Plan, Hand, Session, Operator>;

/// The text of a source in recordings and in the window, as quoted with each kind.
std::string toText(const Source& source);
/// Reads such a text; `toText` of the result is always the same text again. A plan is known by the separator in its
/// path, so that a path of one node is read as a behavior's state.
Source readSource(std::string_view text);

} // namespace by

/// The reason why a command was sent. `trigger` is the info line that led to the decision, or 0 if there was none.
struct Cause {
    by::Source source;
    LineNumber trigger;
    bool operator==(const Cause&) const = default;
};

} // namespace usar
