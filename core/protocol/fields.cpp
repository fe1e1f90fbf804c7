#include "core/protocol/fields.h"

#include <array>
#include <cmath>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/base/numbers.h"
#include "core/protocol/generic_fields.h"
#include "core/protocol/segments.h"
#include "core/protocol/vehicle_words.h"

namespace usar::protocol {

namespace {

/// Collects the fields of one message.
struct Collector {
    std::string source;
    std::string item;
    std::vector<Field> fields;

    void text(std::string_view field, std::string_view value) {
        fields.push_back({source, item, std::string(field), std::nullopt, std::string(value), {}});
    }
    void number(std::string_view field, double value, std::string_view unit = {}) {
        if (std::isfinite(value))
            fields.push_back({source, item, std::string(field), value, {}, std::string(unit)});
        else
            fields.push_back({source, item, std::string(field), std::nullopt, "nan", std::string(unit)});
    }
    template <class Number>
    void number(std::string_view field, const std::optional<Number>& value, std::string_view unit = {}) {
        if (value)
            number(field, static_cast<double>(*value), unit);
    }
    void flag(std::string_view field, const std::optional<bool>& value) {
        if (value)
            text(field, *value ? "True" : "False");
    }
    void pose(const Pose& pose) {
        number("x", pose.position_m.x(), "m");
        number("y", pose.position_m.y(), "m");
        number("z", pose.position_m.z(), "m");
        number("roll", pose.roll_rad, "rad");
        number("pitch", pose.pitch_rad, "rad");
        number("yaw", pose.yaw_rad, "rad");
    }

    void add(const GenericMessage& message) { fields = genericFieldsOf(message); }
    void add(const GameInfo& game) {
        source = "NFO";
        text("game_type", game.game_type);
        text("level", game.level);
        number("time_limit", game.time_limit_min, "min");
    }
    void add(const StartPoses& start) {
        source = "NFO StartPoses";
        for (const StartPose& place : start.poses) {
            item = place.name;
            pose(place.pose_in_map);
        }
    }
    void add(const LockstepInfo& lockstep) {
        source = "NFO";
        flag("lockstep", lockstep.on);
    }
    void add(const RobotState& state);
    void add(const SonarReadings& sonars) {
        source = "SEN Sonar";
        for (const NamedRange& sonar : sonars.ranges) {
            item = sonar.name;
            number("range", sonar.range_m, "m");
        }
    }
    void add(const RangeScan& scan);
    void add(const InsReading& reading) {
        source = "SEN INS";
        item = reading.name;
        pose(reading.base_in_map);
    }
    void add(const GroundTruthReading& reading) {
        source = "SEN GroundTruth";
        item = reading.name;
        pose(reading.base_in_map);
    }
    void add(const OdometryReading& reading) {
        source = "SEN Odometry";
        item = reading.name;
        if (!reading.base_in_start)
            return;
        number("x", reading.base_in_start->position_m.x(), "m");
        number("y", reading.base_in_start->position_m.y(), "m");
        number("yaw", reading.base_in_start->yaw_rad, "rad");
    }
    void add(const EncoderReadings& encoders) {
        source = "SEN Encoder";
        for (const EncoderTicks& encoder : encoders.encoders) {
            item = encoder.name;
            number("ticks", static_cast<double>(encoder.ticks));
        }
    }
    void add(const GeometryInfo& geometry);
    void add(const ConfigurationInfo& configuration) {
        source = "CONF " + configuration.type;
        for (const ConfiguredItem& configured : configuration.items) {
            item = configured.name;
            for (const Setting& setting : configured.settings)
                fields.push_back({source, item, setting.key, setting.number, setting.value, {}});
        }
    }
    void add(const Response& response) {
        source = "RES " + response.type;
        item = response.name;
        text("status", response.ok ? "OK" : "Failed");
    }
};

void Collector::add(const RobotState& state) {
    source = "STA";
    if (state.kind != VehicleKind::Unknown)
        text("kind", wordOf(state.kind));
    if (state.battery_left)
        number("battery", state.battery_left->count(), "s");
    number("front_steer", state.front_steer_rad, "rad");
    number("rear_steer", state.rear_steer_rad, "rad");
    flag("light", state.light_on);
    number("light_intensity", state.light_intensity_pct, "%");
    number("view", state.view);
    for (const JointAngle& joint : state.joints) {
        item = joint.name;
        number("angle", joint.angle_rad, "rad");
    }
    item.clear();
    for (const KeyValue& other : state.others)
        if (sameWord(other.key, "Type"))
            text("kind", other.value);
    for (Field& field : genericFieldsOf({source, {}, {}, state.others}))
        fields.push_back(std::move(field));
}

void Collector::add(const RangeScan& scan) {
    source = scan.type.empty() ? "SEN" : "SEN " + scan.type;
    item = scan.name;
    number("resolution", scan.resolution_rad, "rad");
    number("fov", scan.fov_rad, "rad");
    const ListSummary summary = summaryOf(scan.ranges_m);
    number("count", static_cast<double>(scan.ranges_m.size()));
    number("minimum", summary.minimum, "m");
    number("mean", summary.mean, "m");
    number("maximum", summary.maximum, "m");
}

void Collector::add(const GeometryInfo& geometry) {
    source = "GEO " + geometry.type;
    item = geometry.robot_class;
    static constexpr std::array sizes = {"length", "width", "height"};
    static constexpr std::array centers = {"center_x", "center_y", "center_z"};
    for (int axis = 0; axis < 3; ++axis) {
        if (geometry.dimensions_m)
            number(sizes[static_cast<std::size_t>(axis)], (*geometry.dimensions_m)[axis], "m");
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (geometry.center_of_gravity_m)
            number(centers[static_cast<std::size_t>(axis)], (*geometry.center_of_gravity_m)[axis], "m");
    }
    number("wheel_radius", geometry.wheel_radius_m, "m");
    number("wheel_separation", geometry.wheel_separation_m, "m");
    number("wheel_base", geometry.wheel_base_m, "m");
    for (const MountedItem& mounted : geometry.items) {
        item = mounted.name;
        pose(mounted.item_in_mount);
        text("mount", mounted.mount);
    }
}

std::optional<Seconds> genericTime(const GenericMessage& message) {
    for (const KeyValue& segment : message.segments) {
        if (!sameWord(segment.key, "Time"))
            continue;
        const std::optional<double> time_s = readNumber(segment.value);
        return time_s && std::isfinite(*time_s) ? std::optional(Seconds(*time_s)) : std::nullopt;
    }
    return std::nullopt;
}

} // namespace

std::string Field::path() const {
    std::string result = source + '/';
    if (!item.empty())
        result += item + '/';
    return result + field;
}

std::vector<Field> fieldsOf(const InfoMessage& message) {
    Collector collector;
    std::visit([&collector](const auto& value) { collector.add(value); }, message);
    return std::move(collector.fields);
}

std::optional<Seconds> timeOf(const InfoMessage& message) {
    return std::visit(
        [](const auto& value) -> std::optional<Seconds> {
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, GenericMessage>)
                return genericTime(value);
            else if constexpr (requires { value.time; })
                return value.time;
            else
                return std::nullopt;
        },
        message);
}

} // namespace usar::protocol
