// Values and blackboard changes as traces and reports print them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Appends nil, true, 5, 2.0 (whole floats keep one decimal), "text" (quoted as in JSON; nothing beyond ASCII is
/// escaped) or 'symbol.
void appendValue(std::string& out, const Value& value);
std::string toText(const Value& value);

/// One change of a blackboard entry. The views point into the text of a TraceEvent::Blackboard; the values are spelled
/// as traces print them.
struct BoardChange {
    std::string_view key;
    std::string_view old_value;
    std::string_view new_value;
};

/// Formats a change as "lane: 2 -> 3"; the values must already be spelled as traces print them.
std::string boardChangeText(std::string_view key, std::string_view old_value, std::string_view new_value);
/// Parses the text of a change. Returns nullopt if it is malformed, which happens when a trace file is damaged.
std::optional<BoardChange> readBoardChange(std::string_view text);

} // namespace usar::posh
