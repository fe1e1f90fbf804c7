// The text of a blackboard change in a trace: "lane: 2 -> 3".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace usar::posh {

/// One change of a blackboard entry. The views point into the text of a TraceEvent::Blackboard; the values are spelled
/// as traces print them (see value_text.h).
struct BoardChange {
    std::string_view key;
    std::string_view old_value;
    std::string_view new_value;
};

/// Formats a change; the values must already be spelled as traces print them.
std::string boardChangeText(std::string_view key, std::string_view old_value, std::string_view new_value);
/// Parses the text of a change. Returns nullopt if it is malformed, which happens when a trace file is damaged.
std::optional<BoardChange> readBoardChange(std::string_view text);

} // namespace usar::posh
