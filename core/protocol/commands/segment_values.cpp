#include "core/protocol/commands/segment_values.h"

#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/commands/wire_degrees.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

void SegmentValues::warn(std::string_view part, std::string message) {
    diagnostics_.push_back({Severity::Warning, segments_.offsetOf(part), std::move(message)});
}

void SegmentValues::refuse(std::string_view part, std::string message) {
    if (!std::exchange(refused_, true))
        warn(part, std::move(message));
}

void SegmentValues::refuseWithout(std::string_view key) {
    refuse(segments_.line(), std::string(segments_.typeWord()) + " needs a " + std::string(key));
}

bool SegmentValues::takeNumbersOf(const Segment& segment, std::span<double> values) {
    std::string_view rest = segment.value;
    const bool good = takeNumbers(rest, values) && trimmed(rest).empty();
    for (double& value : values)
        value = std::isfinite(value) ? value : 0.0;
    if (!good)
        warn(segment.text, "not exactly " + std::to_string(values.size()) +
                               (values.size() == 1 ? " number" : " numbers") + "; read as far as possible");
    return good;
}

int SegmentValues::wholeOf(const Segment& segment) {
    const double value = numberOf(segment);
    constexpr double most = 1e9;
    if (value != std::trunc(value) || std::abs(value) > most)
        refuse(segment.text, std::string(segment.key) + " takes a whole number");
    return static_cast<int>(std::clamp(value, -most, most));
}

/// Reads the digits with more precision than a double has, because appendDegrees may have written more.
double SegmentValues::radiansOf(const Segment& segment) {
    numberOf(segment); // warns if this is not a number
    const NumberPrefix prefix = readNumberPrefix(segment.value);
    return std::isfinite(prefix.value) ? radiansOfDegrees(segment.value.substr(0, prefix.used)) : 0.0;
}

bool SegmentValues::booleanOf(const Segment& segment) {
    const std::optional<bool> read = readBoolean(segment.value);
    if (!read)
        warn(segment.text, "neither true nor false; read as false");
    return read.value_or(false);
}

} // namespace usar::protocol
