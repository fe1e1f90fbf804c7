#include "core/link/recording_text.h"

#include <array>
#include <charconv>
#include <utility>

#include "core/base/quoted_text.h"
#include "core/base/text.h"

namespace usar::link::recording {

namespace {

constexpr std::array<std::pair<RecordKind, std::string_view>, 7> kind_words{{{RecordKind::Start, "start"},
                                                                             {RecordKind::Opened, "opened"},
                                                                             {RecordKind::Closed, "closed"},
                                                                             {RecordKind::In, "in"},
                                                                             {RecordKind::Out, "out"},
                                                                             {RecordKind::Note, "note"},
                                                                             {RecordKind::End, "end"}}};
constexpr std::int64_t nanoseconds_a_second = 1'000'000'000;

void appendKind(std::string& text, RecordKind kind) {
    for (const auto& [known, word] : kind_words)
        if (known == kind) {
            text += word;
            return;
        }
    text += std::to_string(static_cast<unsigned>(kind));
}

template <class Integer>
bool readWhole(std::string_view word, Integer& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

bool readKind(std::string_view word, RecordKind& kind) {
    for (const auto& [known, spelled] : kind_words)
        if (spelled == word) {
            kind = known;
            return true;
        }
    unsigned number = 0;
    if (!readWhole(word, number) || number == 0 || number > 255)
        return false;
    kind = static_cast<RecordKind>(number);
    return true;
}

void appendSeconds(std::string& text, RecordTime time) {
    const auto whole = static_cast<std::uint64_t>(time.count());
    const std::string fraction = std::to_string(whole % nanoseconds_a_second);
    text += std::to_string(whole / nanoseconds_a_second) + '.' + std::string(9 - fraction.size(), '0') + fraction;
}

bool readSeconds(std::string_view word, RecordTime& time) {
    const auto point = word.find('.');
    std::uint64_t seconds = 0;
    std::uint64_t fraction = 0;
    if (point == std::string_view::npos || word.size() - point != 10 || !readWhole(word.substr(0, point), seconds) ||
        !readWhole(word.substr(point + 1), fraction) || seconds > UINT64_MAX / nanoseconds_a_second - 1)
        return false;
    time = RecordTime(static_cast<std::int64_t>(seconds * nanoseconds_a_second + fraction));
    return true;
}

} // namespace

void appendText(std::string& text, const Record& record) {
    appendKind(text, record.kind);
    text += ' ';
    appendSeconds(text, record.time);
    text += ' ' + std::to_string(record.line.value) + ' ';
    if (record.kind == RecordKind::Out || record.kind == RecordKind::Note) {
        text += std::to_string(record.trigger.value) + ' ';
        appendQuoted(text, record.name);
        text += ' ';
    }
    appendQuoted(text, record.bytes);
    text += '\n';
}

Result<Record> TextRecord::read(std::string_view line) {
    std::string_view rest = line;
    const auto wrong = [&](std::string what, std::string mend) {
        return failure(std::move(what), "column " + std::to_string(line.size() - rest.size() + 1), std::move(mend));
    };
    Record record;
    if (!readKind(takeWord(rest), record.kind))
        return wrong("the line does not begin with a kind of record",
                     "Write start, opened, closed, in, out, note, end or a number from 1 to 255");
    if (!readSeconds(takeWord(rest), record.time))
        return wrong("the time is not seconds with nine decimals", "Write for example 12.345000000");
    if (!readWhole(takeWord(rest), record.line.value))
        return wrong("the line number is not a whole number", "Write the number of the newest info line, or 0");
    if (record.kind == RecordKind::Out || record.kind == RecordKind::Note) {
        if (!readWhole(takeWord(rest), record.trigger.value))
            return wrong("the triggering line is not a whole number", "Write its number, or 0");
        if (!takeQuoted(rest, name_) || name_.size() > 0xFFFF)
            return wrong("the name is not a text in quotes", "Write for example \"session: connect\"");
        record.name = name_;
    }
    if (!takeQuoted(rest, bytes_) || !trimmed(rest).empty())
        return wrong("the bytes are not one text in quotes at the end of the line",
                     "Escape quotes inside it as \\\" and backslashes as \\\\");
    record.bytes = bytes_;
    return record;
}

} // namespace usar::link::recording
