#include "core/protocol/commands/line_in.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// True if the list contains "nan", "inf" or a number larger than anything sensed. Other words count as 0, as
/// everywhere.
bool hasNotANumber(std::string_view list) {
    double value = 0.0;
    bool clean = false;
    while (takeNumber(list, value, clean))
        if (clean && !isPlausible(value))
            return true;
    return false;
}

} // namespace

const Segment* LineIn::find(std::string_view key) {
    if (!only_)
        return segments().find(key);
    if (!sameWord(only_->key, key))
        return nullptr;
    only_is_known_ = true;
    return only_;
}

void LineIn::number(const Key& key, std::optional<double>& value, NumberForm form) {
    const Segment* const segment = find(key);
    if (!segment) {
        for (const Segment& other : segments().all())
            if (form.keyless && !value)
                value = readNumber(other.text);
        return;
    }
    value = form.degrees ? radiansOf(*segment) : numberOf(*segment);
    if (form.scaled && normalized_ && std::abs(*value) > 100.0) {
        warn(segment->value, "beyond 100 percent; limited to it");
        value = std::clamp(*value, -100.0, 100.0);
    }
    if (form.turned)
        value = acrossWire(*value);
}

void LineIn::number(const Key& key, std::optional<int>& value, NumberForm) {
    if (const Segment* const segment = find(key))
        value = wholeOf(*segment);
}

void LineIn::number(const Key& key, std::optional<Seconds>& value, NumberForm) {
    if (const Segment* const segment = find(key))
        value = Seconds{numberOf(*segment)};
}

void LineIn::beginScale(bool& normalized) {
    flag(normalized_key, normalized);
    normalized_ = normalized;
}

void LineIn::flag(const Key& key, std::optional<bool>& value) {
    if (const Segment* const segment = find(key))
        value = booleanOf(*segment);
}

void LineIn::flag(const Key& key, bool& value) {
    if (const Segment* const segment = find(key))
        value = booleanOf(*segment);
}

void LineIn::neededFlag(const Key& key, bool& value) {
    if (const std::optional<bool> read = readBoolean(segments().value(key)))
        value = *read;
    else
        refuse(segments().line(), std::string(segments().typeWord()) + " needs " + std::string(key) + " true or false");
}

void LineIn::vector(const Key& key, std::optional<Vec3>& value) {
    if (const Segment* const segment = find(key))
        value = Vec3(numbersOf<3>(*segment).data());
}

void LineIn::vector(const Key& key, Vec3& value) {
    std::optional<Vec3> read;
    vector(key, read);
    take(key, read, value);
}

void LineIn::position(const Key& key, Vec3& value) {
    vector(key, value);
    value = acrossWire(value);
}

void LineIn::position(const Key& key, std::optional<Vec3>& value) {
    vector(key, value);
    if (value)
        value = acrossWire(*value);
}

std::optional<Pose> LineIn::poseOnLine() {
    // Elsewhere such a number counts as 0. What is at 0,0 instead of where its client meant it would mislead.
    if (hasNotANumber(segments().value(location_key)) || hasNotANumber(segments().value(rotation_key))) {
        refuse(segments().line(), "Location and Rotation must be numbers, and neither nan, infinite nor beyond 1e15");
        return std::nullopt;
    }
    std::optional<Vec3> position_m;
    std::optional<Vec3> angles_rad;
    vector(location_key, position_m);
    vector(rotation_key, angles_rad);
    if (!position_m && !angles_rad)
        return std::nullopt;
    const Vec3 angles = angles_rad.value_or(Vec3::Zero());
    return acrossWire(Pose{position_m.value_or(Vec3::Zero()), angles.x(), angles.y(), angles.z()});
}

void LineIn::start(const Key& key, std::variant<Pose, Token>& start, std::optional<Pose>* fallback) {
    if (segments().value(key).empty()) {
        start = poseOnLine().value_or(Pose{});
        return;
    }
    text(key, start.emplace<Token>("?"));
    if (fallback)
        *fallback = poseOnLine();
}

void LineIn::sixNumbers(const Key& key, Pose& pose) {
    const Segment* const segment = find(key);
    std::array<double, 6> n{};
    if (!segment || !takeNumbersOf(*segment, n))
        return refuse(segments().line(), std::string(key) + " takes exactly six numbers");
    pose = acrossWire(Pose{{n[0], n[1], n[2]}, n[3], n[4], n[5]});
}

void LineIn::goal(const Key& point_key, const Key& node_key, std::variant<Vec2, Token>& goal) {
    if (find(node_key))
        return text(node_key, goal.emplace<Token>("?"));
    const Segment* const point = find(point_key);
    if (!point)
        return refuseWithout(std::string(point_key) + " or a " + std::string(node_key));
    const auto [x, y] = numbersOf<2>(*point);
    goal = Vec2(acrossWire(Vec3(x, y, 0.0)).head<2>());
}

void LineIn::points(const Key& key, std::vector<Vec3>& points) {
    std::string_view rest = segments().value(key);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        std::string_view point = rest.substr(0, end);
        std::array<double, 3> numbers{};
        if (!takeNumbers(point, numbers) || !trimmed(point).empty())
            return refuse(rest, "a waypoint does not consist of three numbers");
        points.push_back(acrossWire(Vec3(numbers.data())));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

void LineIn::box(const Key& min_key, const Key& max_key, std::optional<Box>& box) {
    std::optional<Vec3> min_m;
    std::optional<Vec3> max_m;
    vector(min_key, min_m);
    vector(max_key, max_m);
    if (min_m && max_m)
        box = acrossWire(Box{*min_m, *max_m});
    else if (min_m || max_m)
        refuse(segments().line(), std::string(min_key) + " and " + std::string(max_key) + " need each other");
}

void LineIn::pace(const Key& speed_key, const Key& time_key, std::variant<WaypointSpeed, Seconds>& pace) {
    if (find(speed_key))
        number(speed_key, std::get<WaypointSpeed>(pace).speed_m_s);
    else
        number(time_key, pace.emplace<Seconds>(0.0));
}

void LineIn::valueAndSteer(const Key& key, double& value, std::optional<double>& steer_rad) {
    const Segment* const segment = find(key);
    if (!segment || segment->value.find(',') == std::string_view::npos)
        return number(key, value);
    const auto [first, second] = numbersOf<2>(*segment);
    value = first;
    steer_rad = acrossWire(second);
}

void LineIn::tagAndText(const Key& key, Token& tag, Text& text) {
    std::string_view rest = segments().value(key);
    takeText("tag's number in " + std::string(key), takeWord(rest), tag);
    takeText("text", trimmed(rest), text);
}

} // namespace usar::protocol
