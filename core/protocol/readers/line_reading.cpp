#include "core/protocol/readers/line_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

bool isSeparator(char c) {
    return c == ',' || isSpace(c);
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    return "'" + std::string(text.substr(0, longest)) + (text.size() > longest ? "…'" : "'");
}

} // namespace

bool takeNumber(std::string_view& list, double& value, bool& clean) {
    const auto start = std::ranges::find_if_not(list, isSeparator);
    list.remove_prefix(static_cast<std::size_t>(start - list.begin()));
    if (list.empty())
        return false;
    const NumberPrefix prefix = readNumberPrefix(list);
    value = prefix.used == 0 ? std::numeric_limits<double>::quiet_NaN() : prefix.value;
    const auto end = std::find_if(list.begin() + static_cast<std::ptrdiff_t>(prefix.used), list.end(), isSeparator);
    const auto length = static_cast<std::size_t>(end - list.begin());
    clean = prefix.used != 0 && length == prefix.used;
    list.remove_prefix(length);
    return true;
}

bool takeNumbers(std::string_view& text, std::span<double> numbers) {
    bool good = true;
    for (double& number : numbers) {
        bool clean = false;
        good &= takeNumber(text, number, clean) && clean && std::isfinite(number);
    }
    return good;
}

std::optional<bool> readBoolean(std::string_view text) {
    if (sameWord(text, "true") || text == "1")
        return true;
    if (sameWord(text, "false") || text == "0")
        return false;
    return std::nullopt;
}

void LineReading::warn(std::string_view part, std::string message) {
    diagnostics_.push_back({Severity::Warning, segments_.offsetOf(part), std::move(message)});
}

void LineReading::error(std::string_view part, std::string message) {
    diagnostics_.push_back({Severity::Error, segments_.offsetOf(part), std::move(message)});
}

std::optional<double> LineReading::number(std::string_view key) {
    const Segment* segment = segments_.find(key);
    return segment ? numberIn(segment->value.empty() ? segment->key : segment->value) : std::nullopt;
}

std::optional<double> LineReading::numberIn(std::string_view value) {
    const NumberPrefix prefix = readNumberPrefix(value);
    if (prefix.used == 0 || !std::isfinite(prefix.value)) {
        warn(value, quoted(value) + " is not a number");
        return std::nullopt;
    }
    if (prefix.used != value.size())
        warn(value, "only the start of " + quoted(value) + " is a number");
    return prefix.value;
}

std::optional<Seconds> LineReading::time() {
    const std::optional<double> time_s = number("Time");
    return time_s ? std::optional(Seconds(*time_s)) : std::nullopt;
}

std::optional<bool> LineReading::boolean(std::string_view key) {
    const Segment* segment = segments_.find(key);
    if (!segment)
        return std::nullopt;
    const std::optional<bool> value = readBoolean(segment->value);
    if (!value)
        warn(segment->text, quoted(segment->text) + " is neither True nor False");
    return value;
}

std::optional<Vec3> LineReading::threeNumbers(std::string_view value) {
    std::array<double, 3> numbers;
    std::string_view rest = value;
    if (takeNumbers(rest, numbers) && trimmed(rest).empty())
        return Vec3(numbers[0], numbers[1], numbers[2]);
    error(value, quoted(value) + " is not three numbers");
    return std::nullopt;
}

std::optional<Pose> LineReading::pose(std::string_view location, std::string_view orientation) {
    const std::optional<Vec3> position_m = threeNumbers(location);
    const std::optional<Vec3> angles_rad = threeNumbers(orientation);
    if (!position_m || !angles_rad)
        return std::nullopt;
    return acrossWire(Pose{*position_m, angles_rad->x(), angles_rad->y(), angles_rad->z()});
}

} // namespace usar::protocol
