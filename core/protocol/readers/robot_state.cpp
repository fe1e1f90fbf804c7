#include <array>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"
#include "core/protocol/readers/table.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// Keys of STA that are no joints, in either dialect and in the Gazebo server.
bool isOwnKey(std::string_view key) {
    static constexpr std::array<std::string_view, 9> keys = {
        "Type", "Time", "FrontSteer", "RearSteer", "LightToggle", "LightIntensity", "Battery", "View", "CountPer1sec"};
    for (const std::string_view own : keys) {
        if (sameWord(own, key))
            return true;
    }
    return false;
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

void readJoints(LineReading& line, std::vector<JointAngle>& joints) {
    for (const Segment& segment : line.segments().all()) {
        const std::optional<double> angle_rad = isOwnKey(segment.key) ? std::nullopt : readNumber(segment.value);
        if (angle_rad && std::isfinite(*angle_rad))
            joints.push_back({std::string(segment.key), *angle_rad});
    }
}

} // namespace

std::optional<InfoMessage> readRobotState(LineReading& line) {
    const Segments& segments = line.segments();
    // CONTROL GetSTA is answered with an STA of a thing in the world: it has a Size or a Name, never a robot's state.
    if (segments.find("Size") || segments.find("Name") || segments.all().empty())
        return std::nullopt;
    RobotState state;
    state.kind = vehicleKindOf(segments.value("Type"));
    state.time = line.time();
    if (const std::optional<double> battery_s = line.number("Battery"))
        state.battery_left = Seconds(*battery_s);
    state.front_steer_rad = steeringAngle(line, "FrontSteer");
    state.rear_steer_rad = steeringAngle(line, "RearSteer");
    state.light_on = line.boolean("LightToggle");
    state.light_intensity_pct = wholeNumber(line, "LightIntensity");
    state.view = wholeNumber(line, "View");
    readJoints(line, state.joints);
    return state;
}

} // namespace usar::protocol
