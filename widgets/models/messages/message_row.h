// A line of traffic as the message list shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/base/robot_id.h"
#include "core/protocol/info_message.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

/// As seen from this program: `In` came from the server. Commands are `Out`.
enum class Direction { In, Out };

/// A row of the list. The text is as it was on the wire, never shortened: the view elides it, a copy has all of it.
struct MessageRow {
    std::uint64_t number = 0; ///< number of the info line, or of the command (counted per connection)
    Seconds time{0.0};        ///< protocol clock; NaN: unknown
    Direction direction = Direction::In;
    std::string type{}; ///< "SEN Sonar", "DRIVE"
    std::string text{}; ///< the whole line
    std::string note{}; ///< diagnostics of an info line, or who sent a command and why
    /// Worst severity of the diagnostics; nullopt: none.
    std::optional<Severity> trouble{};
    std::uint64_t not_shown = 0; ///< above 0: this row stands for so many lines that were left out here
    ConnectionId connection{};   ///< connection that the line went over; the model knows their names
    std::uint64_t trigger = 0;   ///< number of the info line that caused this command; 0: none
    bool operator==(const MessageRow&) const = default;
};

/// Topic of the line, which decides its color in the list.
LineFamily familyOf(const MessageRow& row);

/// Makes a row from an info line: `note` has all diagnostics, one per line, and `trouble` is the worst of them.
MessageRow rowOf(const protocol::InfoLine& line, Seconds time);
/// Makes a row from a command as it went over the wire; `note` says who sent it and on which info line.
MessageRow rowOf(std::string text, const Cause& cause, std::uint64_t number, Seconds time);
/// Makes a row that says "1,234 lines not shown".
MessageRow gapOf(std::uint64_t not_shown);
/// The first word and the value of the first "{Type …}": "SEN Sonar", "NFO", "DRIVE"; each part has at most 48 bytes.
std::string typeOf(std::string_view line);

} // namespace usar::widgets
