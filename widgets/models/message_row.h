// One line of traffic as the message list shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/protocol/info_message.h"
#include "widgets/theme.h"

namespace usar::widgets {

/// As seen from here: `In` came from the server.
enum class Direction { In, Out };

/// Text as it was on the wire, never shortened: the view elides, a copy is whole.
struct MessageRow {
    std::uint64_t number = 0; ///< of the info line, or of the command since the start
    Seconds time{0.0};        ///< protocol clock; NaN before it is known
    Direction direction = Direction::In;
    std::string type{}; ///< "SEN Sonar", "DRIVE"
    std::string text{}; ///< the whole line
    std::string note{}; ///< what was wrong with it, or why it was sent
    std::optional<Severity> trouble{};
    std::uint64_t not_shown = 0; ///< more than none: stands for so many lines that were left out here
    int connection = 0;          ///< over which it went; the model knows their names
    std::uint64_t trigger = 0;   ///< of a command: the number of the info line that caused it; 0 for none
    bool operator==(const MessageRow&) const = default;
};

/// What a line is about: its color in the list.
LineFamily familyOf(const MessageRow& row);

/// `note` has all diagnostics, one a line; `trouble` is the worst of them.
MessageRow rowOf(const protocol::InfoLine& line, Seconds time);
/// `text` as it went over the wire; `note` says who sent it and on which info line.
MessageRow rowOf(std::string text, const Cause& cause, std::uint64_t number, Seconds time);
/// "1,234 lines not shown".
MessageRow gapOf(std::uint64_t not_shown);
/// First word and the value of the first "{Type …}": "SEN Sonar", "NFO", "DRIVE"; short, however long the words.
std::string typeOf(std::string_view line);

} // namespace usar::widgets
