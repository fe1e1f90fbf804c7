#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"
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

} // namespace usar::protocol
