// One line of traffic as the message list shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/agent/command_port.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

/// As seen from here: `In` came from the server.
enum class Direction { In, Out };

/// Text as it was on the wire, never shortened: the view elides, a copy is whole.
struct MessageRow {
    std::uint64_t number = 0; ///< of the info line, or of the command since the start
    Seconds time{0.0};        ///< protocol clock; NaN before it is known
    Direction direction = Direction::In;
    std::string type; ///< "SEN Sonar", "DRIVE"
    std::string text; ///< the whole line
    std::string note; ///< what was wrong with it, or why it was sent
    std::optional<Severity> trouble;
    std::uint64_t not_shown = 0; ///< more than none: stands for so many lines that were left out here
    bool operator==(const MessageRow&) const = default;
};

/// `note` has all diagnostics, one a line; `trouble` is the worst of them.
MessageRow rowOf(const protocol::InfoLine& line, Seconds time);
/// `note` says who sent it and on which info line, from its cause id.
MessageRow rowOf(const agent::CausedCommand& command, std::uint64_t number, Seconds time, protocol::Dialect dialect);
/// "1,234 lines not shown".
MessageRow gapOf(std::uint64_t not_shown);
/// First word and the value of the first "{Type …}": "SEN Sonar", "NFO", "DRIVE"; short, however long the words.
std::string typeOf(std::string_view line);

} // namespace usar::widgets
