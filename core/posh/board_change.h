// What an act wrote onto the plan's blackboard, as a trace tells it: "lane: 2 -> 3".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace usar::posh {

/// Views into the text of a TraceEvent::Blackboard; the values are spelled as traces print them (see value_text.h).
struct BoardChange {
    std::string_view key;
    std::string_view old_value;
    std::string_view new_value;
};

std::string boardChangeText(std::string_view key, std::string_view old_value, std::string_view new_value);
/// Nothing for a text that is none: a trace may come from a damaged file.
std::optional<BoardChange> readBoardChange(std::string_view text);

} // namespace usar::posh
