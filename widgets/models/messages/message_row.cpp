#include "widgets/models/messages/message_row.h"

#include <algorithm>
#include <limits>

#include "core/base/text.h"
#include "core/protocol/segments.h"

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
    MessageRow row{.number = line.number.value, .time = time, .type = typeOf(line.text), .text = line.text};
    for (const Diagnostic& diagnostic : line.diagnostics) {
        row.note += (row.note.empty() ? "" : "\n") + toText(diagnostic);
        row.trouble = std::max(row.trouble.value_or(Severity::Note), diagnostic.severity);
    }
    return row;
}

MessageRow rowOf(std::string text, const Cause& cause, std::uint64_t number, Seconds time) {
    MessageRow row{.number = number, .time = time, .direction = Direction::Out, .type = typeOf(text)};
    row.text = std::move(text);
    row.note = toText(cause.source);
    row.trigger = cause.trigger.value;
    if (row.trigger > 0)
        row.note += ", on line " + std::to_string(row.trigger);
    return row;
}

LineFamily familyOf(const MessageRow& row) {
    const auto isOneOf = [](std::string_view word, std::initializer_list<std::string_view> words) {
        return std::ranges::any_of(words, [&](std::string_view other) { return sameWord(word, other); });
    };
    std::string_view rest = row.type;
    const std::string_view word = takeWord(rest);
    const std::string_view type = takeWord(rest);
    if (row.direction == Direction::Out)
        return isOneOf(word, {"DRIVE", "MULTIDRIVE"}) ? LineFamily::Drive : LineFamily::Command;
    if (isOneOf(word, {"STA", "MISSTA", "ASTA"}))
        return LineFamily::State;
    if (isOneOf(word, {"NFO", "GEO", "CONF", "RES", "EFF"}))
        return LineFamily::Answer;
    if (!isOneOf(word, {"SEN"}))
        return LineFamily::Other;
    if (isOneOf(type,
                {"Sonar", "SonarSensor", "IR", "IRSensor", "RangeScanner", "RangeImager", "RangeSensor", "IRScanner"}))
        return LineFamily::Range;
    if (isOneOf(type, {"INS", "GroundTruth", "Odometry", "GPS", "Encoder", "Tachometer", "IMU", "Acceleration"}))
        return LineFamily::Pose;
    return LineFamily::Sensor;
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
    constexpr std::size_t longest = 48; // Invalid input may be one endless word.
    const std::size_t at = line.find(key);
    std::string_view rest = line;
    std::string type(takeWord(rest).substr(0, longest));
    if (at == std::string_view::npos)
        return type;
    const std::string_view value = line.substr(at + key.size());
    return type + ' ' + std::string(trimmed(value.substr(0, std::min(longest, value.find('}')))));
}

} // namespace usar::widgets
