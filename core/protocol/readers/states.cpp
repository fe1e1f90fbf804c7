#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/readers/described.h"
#include "core/protocol/readers/info_readers.h"
#include "core/protocol/refill.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// True for the keys of STA, in either dialect, that have a field of their own in RobotState.
bool isOwnKey(std::string_view key) {
    static constexpr std::array<std::string_view, 8> keys = {"Type",        "Time",           "FrontSteer", "RearSteer",
                                                             "LightToggle", "LightIntensity", "Battery",    "View"};
    return std::ranges::any_of(keys, [key](std::string_view own) { return sameWord(own, key); });
}

/// True for the one key whose number is not a joint angle: the message rate that the Gazebo server sends.
bool isNoJoint(std::string_view key) {
    return sameWord(key, "CountPer1sec");
}

std::optional<int> wholeNumber(LineReading& line, std::string_view key) {
    const std::optional<double> value = line.number(key);
    if (!value)
        return std::nullopt;
    constexpr double limit = std::numeric_limits<int>::max();
    if (std::abs(*value) > limit) {
        line.warn(line.segments().value(key), "too large a number");
        return std::nullopt;
    }
    return static_cast<int>(*value);
}

std::optional<double> steeringAngle(LineReading& line, std::string_view key) {
    const std::optional<double> angle_rad = line.number(key);
    return angle_rad ? std::optional(acrossWire(*angle_rad)) : std::nullopt;
}

/// Reads the joints, and keeps everything else that has no field as text, so that nothing is dropped.
void readRest(LineReading& line, RobotState& state) {
    Refill<JointAngle> joints(state.joints);
    Refill<KeyValue> others(state.others);
    for (const Segment& segment : line.segments().all()) {
        const bool own = isOwnKey(segment.key);
        const double angle_rad = readNumber(segment.value).value_or(std::numeric_limits<double>::quiet_NaN());
        const bool unknown_kind = sameWord(segment.key, "Type") && state.kind == VehicleKind::Unknown;
        if (!own && !isNoJoint(segment.key) && isPlausible(angle_rad)) {
            JointAngle& joint = joints.next();
            joint.name = segment.key;
            joint.angle_rad = angle_rad;
        } else if (!own || unknown_kind || line.segments().find(segment.key) != &segment) {
            KeyValue& other = others.next();
            other.key = segment.key;
            other.value = segment.value;
        }
    }
}

/// Splits the value of a Location segment into location and memory. The server's braces are malformed: `{Location x,y,z
/// {Memory {m} {Rotation r,p,y}` (protocol.md 5.8), so that the tokenizer returns Location and Memory as one
/// segment.
std::pair<std::string_view, std::string_view> splitMemory(std::string_view location) {
    const std::size_t brace = location.find('{');
    if (brace == std::string_view::npos)
        return {location, {}};
    std::string_view memory = location.substr(brace + 1);
    takeWord(memory);
    memory = trimmed(memory);
    if (memory.starts_with('{'))
        memory.remove_prefix(1);
    return {trimmed(location.substr(0, brace)), trimmed(memory)};
}

struct ObjectText {
    std::string_view location;
    std::string_view rotation;
};

bool finish(LineReading& line, const ObjectText& text, WorldObject& object) {
    const std::optional<Pose> pose =
        line.pose(text.location, text.rotation.empty() ? std::string_view("0,0,0") : text.rotation);
    object.object_in_map = pose.value_or(Pose{});
    return pose.has_value();
}

} // namespace

bool read(LineReading& line, RobotState& state) {
    const Segments& segments = line.segments();
    state.kind = vehicleKindOf(segments.value("Type"));
    state.time = line.time();
    const std::optional<double> battery_s = line.number("Battery");
    state.battery_left = battery_s ? std::optional(Seconds(*battery_s)) : std::nullopt;
    state.front_steer_rad = steeringAngle(line, "FrontSteer");
    state.rear_steer_rad = steeringAngle(line, "RearSteer");
    state.light_on = line.boolean("LightToggle");
    state.light_intensity_pct = wholeNumber(line, "LightIntensity");
    state.view = wholeNumber(line, "View");
    readRest(line, state);
    return true;
}

bool read(LineReading& line, PackageState& out) {
    return readDescribed(line, out);
}

bool read(LineReading& line, EffecterState& out) {
    const Segments& segments = line.segments();
    out.time = line.time();
    out.type = segments.value("Type");
    out.name = segments.value("Name");
    out.tool_type = segments.value("ToolType");
    out.tool = segments.value("Tool");
    out.closed = out.on = std::nullopt;
    const auto takeWord = [&out](std::string_view word) {
        if (sameWord(word, "Open") || sameWord(word, "Closed"))
            out.closed = sameWord(word, "Closed");
        else if (sameWord(word, "On") || sameWord(word, "Off"))
            out.on = sameWord(word, "On");
    };
    for (const Segment& segment : segments.all())
        takeWord(sameWord(segment.key, "Status") ? segment.value : segment.key);
    return out.closed || out.on || !out.tool.empty();
}

bool read(LineReading& line, WorldObjects& out) {
    out.objects.clear();
    ObjectText text;
    bool good = true;
    for (const KeyedText& pair : line.pairs(false)) {
        if (sameWord(pair.key, "Name")) {
            if (!out.objects.empty())
                good &= finish(line, text, out.objects.back());
            text = {};
            out.objects.emplace_back().name = pair.value;
        } else if (out.objects.empty()) {
            continue;
        } else if (sameWord(pair.key, "Size")) {
            good &= take(line, pair.value, out.objects.back().size_m, Crossing::None);
        } else if (sameWord(pair.key, "Location")) {
            const auto [location, memory] = splitMemory(pair.value);
            text.location = location;
            out.objects.back().memory = memory;
        } else if (sameWord(pair.key, "Memory")) {
            out.objects.back().memory = pair.value;
        } else if (sameWord(pair.key, "Rotation")) {
            text.rotation = pair.value;
        }
    }
    if (!out.objects.empty())
        good &= finish(line, text, out.objects.back());
    return good;
}

} // namespace usar::protocol
