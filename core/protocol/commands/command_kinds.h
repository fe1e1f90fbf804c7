// What each command says about itself (commands/description.h), as a list that reader and grammar search.
#pragma once

#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/commands/line_in.h"

namespace usar::protocol {

/// A command to read values into. Tokens cannot be empty and begin as "?", which is replaced when the line is read; if
/// the line is refused, the command is discarded.
template <class T>
T blank() {
    if constexpr (std::is_default_constructible_v<T>)
        return T{};
    else if constexpr (requires { T{"?"}; })
        return T{"?"};
    else
        return T{"?", "?"};
}

/// One alternative of Command. `segments` are in the order of the wire, `marks` those of them that have a fixed word.
struct CommandKind {
    const CommandWord& word;
    std::vector<SegmentRule> segments;
    std::vector<SegmentRule> marks;
    std::span<const std::string_view> signs;
    std::span<const std::string_view> weak_signs;
    Command (*read)(LineIn& line);
};

/// Every alternative except RawCommand, in the order of CommandVariant. Made at the first call; any thread may call it.
std::span<const CommandKind> commandKinds();

} // namespace usar::protocol
