#include "widgets/models/message_row.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/protocol/command_writer.h"

namespace usar::widgets {

MessageRow rowOf(const protocol::InfoLine& line, Seconds time) {
    MessageRow row{line.number.value, time, Direction::In, typeOf(line.text), line.text, {}, {}};
    for (const Diagnostic& diagnostic : line.diagnostics) {
        row.note += (row.note.empty() ? "" : "\n") + toText(diagnostic);
        row.trouble = std::max(row.trouble.value_or(Severity::Note), diagnostic.severity);
    }
    return row;
}

MessageRow rowOf(const agent::CausedCommand& command, std::uint64_t number, Seconds time, protocol::Dialect dialect) {
    std::string text = protocol::write(command.command, dialect);
    std::string note = command.cause.source;
    if (command.cause.trigger.value > 0)
        note += ", on line " + std::to_string(command.cause.trigger.value);
    std::string type = typeOf(text);
    return {number, time, Direction::Out, std::move(type), std::move(text), std::move(note), {}};
}

std::string typeOf(std::string_view line) {
    constexpr std::string_view key = "{Type ";
    constexpr std::size_t longest = 48; // garbage may be one endless word
    const std::size_t at = line.find(key);
    std::string_view rest = line;
    std::string type(takeWord(rest).substr(0, longest));
    if (at == std::string_view::npos)
        return type;
    const std::string_view value = line.substr(at + key.size());
    return type + ' ' + std::string(trimmed(value.substr(0, std::min(longest, value.find('}')))));
}

} // namespace usar::widgets
