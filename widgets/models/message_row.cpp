#include "widgets/models/message_row.h"

#include <algorithm>
#include <limits>

#include "core/base/text.h"
#include "core/protocol/command_writer.h"

namespace usar::widgets {

namespace {

std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3; at -= 3)
        digits.insert(at - 3, 1, ',');
    return digits;
}

} // namespace

MessageRow rowOf(const protocol::InfoLine& line, Seconds time) {
    MessageRow row{line.number.value, time, Direction::In, typeOf(line.text), line.text, {}, {}, 0};
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
    return {number, time, Direction::Out, std::move(type), std::move(text), std::move(note), {}, 0};
}

MessageRow gapOf(std::uint64_t not_shown) {
    MessageRow row;
    row.time = Seconds(std::numeric_limits<double>::quiet_NaN());
    row.text = grouped(not_shown) + (not_shown == 1 ? " line not shown" : " lines not shown");
    row.note = "They came faster than the list takes them; all of them were read.";
    row.trouble = Severity::Note;
    row.not_shown = not_shown;
    return row;
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
