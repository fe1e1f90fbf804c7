#include "core/protocol/readers/line_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"
#include "core/base/plain_decimal.h"
#include "core/base/text.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

bool isSeparator(char c) {
    return c == ',' || isSpace(c);
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string words = "'";
    words += text.substr(0, longest);
    words += text.size() > longest ? "…'" : "'";
    return words;
}

/// Reads an element that is not a plain decimal, up to its comma.
double readOddElement(const char*& at, const char* end, std::size_t& doubtful) {
    const char* const stop = std::find(at, end, ',');
    const std::string_view element = trimmed({at, static_cast<std::size_t>(stop - at)});
    at = stop;
    const NumberPrefix prefix = readNumberPrefix(element);
    const bool plausible = isPlausible(prefix.value);
    if (prefix.used != element.size() || !plausible || element.empty())
        ++doubtful;
    return prefix.used == 0 || !plausible ? std::numeric_limits<double>::quiet_NaN() : prefix.value;
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
        good &= takeNumber(text, number, clean) && clean && isPlausible(number);
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

const KeyedText* findPair(std::span<const KeyedText> pairs, std::string_view key, std::string_view other_key) {
    for (const KeyedText& pair : pairs)
        if (sameWord(pair.key, key) || (!other_key.empty() && sameWord(pair.key, other_key)))
            return &pair;
    return nullptr;
}

std::span<const KeyedText> LineReading::pairs(bool split_names) {
    pairs_.clear();
    for (const Segment& segment : segments_.all()) {
        if (split_names && sameWord(segment.key, "Name")) {
            NamedPairs named(segment.value);
            pairs_.push_back({segment.key, named.name()});
            for (KeyedText pair; named.next(pair.key, pair.value);)
                pairs_.push_back(pair);
        } else if (!sameWord(segment.key, "Type") && !sameWord(segment.key, "Time")) {
            pairs_.push_back({segment.key, segment.value});
        }
    }
    return pairs_;
}

void LineReading::add(Severity severity, std::string_view part, std::string message) {
    if (diagnostics_.size() < most_diagnostics)
        diagnostics_.push_back({severity, segments_.offsetOf(part), std::move(message)});
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
    if (!isPlausible(prefix.value)) {
        warn(value, quoted(value) + " is larger than anything sensed");
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

bool take(LineReading& line, std::string_view value, double& member, Crossing crossing) {
    const std::optional<double> number = line.numberIn(value);
    member = number.value_or(std::numeric_limits<double>::quiet_NaN());
    if (crossing == Crossing::Turn)
        member = acrossWire(member);
    return true;
}

bool take(LineReading& line, std::string_view value, std::optional<double>& member, Crossing crossing) {
    member = line.numberIn(value);
    if (member && crossing == Crossing::Turn)
        member = acrossWire(*member);
    return true;
}

bool take(LineReading& line, std::string_view value, long long& member, Crossing) {
    const std::optional<long long> number = readInteger(value);
    if (!number)
        line.error(value, quoted(value) + " is not a whole number");
    member = number.value_or(0);
    return number.has_value();
}

bool take(LineReading& line, std::string_view value, std::optional<long long>& member, Crossing) {
    member = readInteger(value);
    if (!member)
        line.warn(value, quoted(value) + " is not a whole number");
    return true;
}

bool take(LineReading& line, std::string_view value, bool& member, Crossing) {
    const std::optional<bool> flag = readBoolean(value);
    if (!flag)
        line.error(value, quoted(value) + " is neither True nor False");
    member = flag.value_or(false);
    return flag.has_value();
}

bool take(LineReading& line, std::string_view value, std::optional<bool>& member, Crossing) {
    member = readBoolean(value);
    if (!member)
        line.warn(value, quoted(value) + " is neither True nor False");
    return true;
}

bool take(LineReading&, std::string_view, Present& member, Crossing) {
    member = Present::Yes;
    return true;
}

bool take(LineReading&, std::string_view value, std::string& member, Crossing) {
    member = value;
    return true;
}

bool take(LineReading&, std::string_view value, std::optional<std::string>& member, Crossing) {
    if (member)
        *member = value;
    else
        member.emplace(value);
    return true;
}

bool take(LineReading& line, std::string_view value, std::optional<Seconds>& member, Crossing) {
    const std::optional<double> number_s = line.numberIn(value);
    member = number_s ? std::optional(Seconds(*number_s)) : std::nullopt;
    return true;
}

bool take(LineReading& line, std::string_view value, Vec3& member, Crossing crossing) {
    const std::optional<Vec3> on_wire = line.threeNumbers(value);
    if (!on_wire)
        return false;
    if (crossing == Crossing::Angles) {
        const Pose turned = acrossWire(Pose{Vec3::Zero(), on_wire->x(), on_wire->y(), on_wire->z()});
        member = {turned.roll_rad, turned.pitch_rad, turned.yaw_rad};
    } else {
        member = crossing == Crossing::Vector ? acrossWire(*on_wire) : *on_wire;
    }
    return true;
}

bool take(LineReading& line, std::string_view value, std::optional<Vec3>& member, Crossing crossing) {
    return take(line, value, member.emplace(Vec3::Zero()), crossing);
}

/// Reads `x,y,theta`, a pose on the ground.
bool take(LineReading& line, std::string_view value, std::optional<Pose>& member, Crossing) {
    const std::optional<Vec3> on_wire = line.threeNumbers(value);
    if (on_wire)
        member = acrossWire(Pose{.position_m = {on_wire->x(), on_wire->y(), 0.0}, .yaw_rad = on_wire->z()});
    return on_wire.has_value();
}

bool take(LineReading& line, std::string_view value, std::vector<double>& member, Crossing) {
    const std::size_t doubtful = readNumberList(value, member);
    if (doubtful > 0)
        line.warn(value,
                  std::to_string(doubtful) + " of " + std::to_string(member.size()) + " values are not plain numbers");
    return true;
}

std::optional<Pose> LineReading::pose(std::string_view location, std::string_view orientation) {
    const std::optional<Vec3> position_m = threeNumbers(location);
    const std::optional<Vec3> angles_rad = threeNumbers(orientation);
    if (!position_m || !angles_rad)
        return std::nullopt;
    return acrossWire(Pose{*position_m, angles_rad->x(), angles_rad->y(), angles_rad->z()});
}

std::size_t readNumberList(std::string_view text, std::vector<double>& numbers) {
    numbers.clear();
    text = trimmed(text);
    if (text.ends_with(','))
        text.remove_suffix(1);
    if (text.empty())
        return 0;
    std::size_t doubtful = 0;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        const char* const start = at;
        double number = 0.0;
        if (!readPlainDecimal(at, end, number) || (at != end && *at != ',')) {
            at = start;
            number = readOddElement(at, end, doubtful);
        }
        numbers.push_back(number);
        if (at == end)
            return doubtful;
        ++at;
    }
}

} // namespace usar::protocol
