// TRACE: makes the robot leave marks on the ground; UT2004 only.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/protocol/commands/description.h"

namespace usar::protocol {

enum class TraceColor { Red, Yellow, Green, Cyan, White, Blue, Purple };
template <>
inline constexpr std::array wire_words<TraceColor> = {
    WireWord{"Red", TraceColor::Red},      WireWord{"Yellow", TraceColor::Yellow}, WireWord{"Green", TraceColor::Green},
    WireWord{"Cyan", TraceColor::Cyan},    WireWord{"White", TraceColor::White},   WireWord{"Blue", TraceColor::Blue},
    WireWord{"Purple", TraceColor::Purple}};

/// Absent values keep the settings of the previous TRACE.
/// On the wire: `TRACE {On true} {Interval 0.5} {Color Red}`.
struct Trace {
    bool on = true;
    std::optional<Seconds> interval{}; ///< time between marks while the robot moves
    std::optional<TraceColor> color{};
    bool operator==(const Trace&) const = default;

    static constexpr CommandWord word{"TRACE", "leaves marks where the robot has been (UT2004)",
                                      "TRACE {On true} {Interval 0.5} {Color Red}"};
    static void segments(auto& io, auto& trace) {
        io.flag({"On", "whether to leave marks"}, trace.on);
        io.number({"Interval", "seconds between marks"}, trace.interval);
        io.choice({"Color", "color of the marks"}, trace.color);
    }
};

} // namespace usar::protocol
