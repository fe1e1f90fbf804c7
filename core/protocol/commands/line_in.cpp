#include "core/protocol/commands/line_in.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/commands/wire_degrees.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

void LineIn::warn(std::string_view part, std::string message) {
    diagnostics_.push_back({Severity::Warning, segments_.offsetOf(part), std::move(message)});
}

void LineIn::refuse(std::string_view part, std::string message) {
    if (!std::exchange(refused_, true))
        warn(part, std::move(message));
}

bool LineIn::takeNumbersOf(const Segment& segment, std::span<double> values) {
    std::string_view rest = segment.value;
    const bool good = takeNumbers(rest, values) && trimmed(rest).empty();
    for (double& value : values)
        value = std::isfinite(value) ? value : 0.0;
    if (!good)
        warn(segment.text, "not exactly " + std::to_string(values.size()) +
                               (values.size() == 1 ? " number" : " numbers") + "; taken as far as it goes");
    return good;
}

int LineIn::wholeOf(const Segment& segment) {
    const double value = numberOf(segment);
    constexpr double most = 1e9;
    if (value != std::trunc(value) || std::abs(value) > most)
        refuse(segment.text, std::string(segment.key) + " takes a whole number");
    return static_cast<int>(std::clamp(value, -most, most));
}

void LineIn::number(std::string_view key, double& value) {
    if (const Segment* const segment = segments_.find(key))
        value = numberOf(*segment);
    else
        refuse(segments_.line(), std::string(segments_.typeWord()) + " needs a " + std::string(key));
}

void LineIn::number(std::string_view key, std::optional<double>& value) {
    if (const Segment* const segment = segments_.find(key))
        value = numberOf(*segment);
}

void LineIn::flipped(std::string_view key, std::optional<double>& value) {
    number(key, value);
    if (value)
        value = acrossWire(*value);
}

/// Reads the digits with more precision than a double has, because appendDegrees may have written more.
void LineIn::degrees(std::string_view key, std::optional<double>& angle_rad) {
    const Segment* const segment = segments_.find(key);
    if (!segment)
        return;
    numberOf(*segment); // warns if this is not a number
    const NumberPrefix prefix = readNumberPrefix(segment->value);
    angle_rad = std::isfinite(prefix.value) ? radiansOfDegrees(segment->value.substr(0, prefix.used)) : 0.0;
}

void LineIn::flippedDegrees(std::string_view key, std::optional<double>& angle_rad) {
    degrees(key, angle_rad);
    if (angle_rad)
        angle_rad = acrossWire(*angle_rad);
}

void LineIn::beginScale(bool& normalized) {
    flag("Normalized", normalized);
    normalized_ = normalized;
}

void LineIn::speed(std::string_view key, std::optional<double>& value) {
    number(key, value);
    if (!normalized_ || !value || std::abs(*value) <= 100.0)
        return;
    warn(segments_.value(key), "beyond 100 per cent; cut");
    value = std::clamp(*value, -100.0, 100.0);
}

void LineIn::flippedSpeed(std::string_view key, std::optional<double>& value) {
    speed(key, value);
    if (value)
        value = acrossWire(*value);
}

void LineIn::whole(std::string_view key, std::optional<int>& value) {
    if (const Segment* const segment = segments_.find(key))
        value = wholeOf(*segment);
}

void LineIn::seconds(std::string_view key, Seconds& value) {
    double count = 0.0;
    number(key, count);
    value = Seconds{count};
}

void LineIn::seconds(std::string_view key, std::optional<Seconds>& value) {
    if (const Segment* const segment = segments_.find(key))
        value = Seconds{numberOf(*segment)};
}

void LineIn::flag(std::string_view key, std::optional<bool>& value) {
    const Segment* const segment = segments_.find(key);
    if (!segment)
        return;
    const std::optional<bool> read = readBoolean(segment->value);
    if (!read)
        warn(segment->text, "neither true nor false; taken as false");
    value = read.value_or(false);
}

void LineIn::flag(std::string_view key, bool& value) {
    std::optional<bool> read;
    flag(key, read);
    value = read.value_or(value);
}

void LineIn::vector(std::string_view key, std::optional<Vec3>& value) {
    if (const Segment* const segment = segments_.find(key)) {
        const auto [x, y, z] = numbersOf<3>(*segment);
        value = Vec3(x, y, z);
    }
}

void LineIn::vector(std::string_view key, Vec3& value) {
    std::optional<Vec3> read;
    vector(key, read);
    if (read)
        value = *read;
    else
        refuse(segments_.line(), std::string(segments_.typeWord()) + " needs a " + std::string(key));
}

void LineIn::position(std::string_view key, Vec3& value) {
    vector(key, value);
    value = acrossWire(value);
}

std::optional<Pose> LineIn::pose() {
    std::optional<Vec3> position_m;
    std::optional<Vec3> angles_rad;
    vector("Location", position_m);
    vector("Rotation", angles_rad);
    if (!position_m && !angles_rad)
        return std::nullopt;
    const Vec3 angles = angles_rad.value_or(Vec3::Zero());
    return acrossWire(Pose{position_m.value_or(Vec3::Zero()), angles.x(), angles.y(), angles.z()});
}

void LineIn::pose(Pose& pose) {
    pose = this->pose().value_or(Pose{});
}

void LineIn::start(std::variant<Pose, Token>& start) {
    if (segments_.value("Start").empty())
        start = pose().value_or(Pose{});
    else
        text("Start", start.emplace<Token>("?"));
}

} // namespace usar::protocol
