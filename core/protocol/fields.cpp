#include "core/protocol/fields.h"

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/type_name.h"
#include "core/protocol/described_fields.h"
#include "core/protocol/field_list.h"
#include "core/protocol/segments.h"
#include "core/protocol/vehicle_words.h"

namespace usar::protocol {

namespace {

void listAll(FieldList& fields, const GenericMessage& message) {
    listGenericFields(message, fields);
}

void listAll(FieldList& fields, const GameInfo& game) {
    fields.source = "NFO";
    fields.text("game_type", game.game_type);
    fields.text("level", game.level);
    fields.number("time_limit", game.time_limit_min, "min");
}

void listPlaces(FieldList& fields, const std::vector<StartPose>& places) {
    for (const StartPose& place : places) {
        fields.item = place.name;
        fields.pose(place.pose_in_map);
    }
}

void listAll(FieldList& fields, const StartPoses& start) {
    fields.source = "NFO StartPoses";
    listPlaces(fields, start.poses);
}

void listAll(FieldList& fields, const PathNodes& path) {
    fields.source = "NFO PathNodes";
    listPlaces(fields, path.nodes);
}

void listAll(FieldList& fields, const ClosestPathNode& node) {
    fields.source = "NFO Pathnode";
    fields.item = node.name;
    fields.vector("", node.position_in_map_m, "m");
}

void listAll(FieldList& fields, const LockstepInfo& lockstep) {
    fields.source = "NFO";
    fields.flag("lockstep", lockstep.on);
}

void listAll(FieldList& fields, const RobotState& state) {
    fields.source = "STA";
    if (state.kind != VehicleKind::Unknown)
        fields.text("kind", wordOf(state.kind));
    if (state.battery_left)
        fields.number("battery", state.battery_left->count(), "s");
    fields.number("front_steer", state.front_steer_rad, "rad");
    fields.number("rear_steer", state.rear_steer_rad, "rad");
    fields.flag("light", state.light_on);
    fields.number("light_intensity", state.light_intensity_pct, "%");
    fields.number("view", state.view);
    for (const JointAngle& joint : state.joints) {
        fields.item = joint.name;
        fields.number("angle", joint.angle_rad, "rad");
    }
    fields.item.clear();
    for (const KeyValue& other : state.others)
        if (sameWord(other.key, "Type"))
            fields.text("kind", other.value);
    listGenericFields({fields.source, {}, {}, state.others}, fields);
}

void listAll(FieldList& fields, const PackageState& package) {
    fields.source = "MISSTA";
    listDescribed(fields, package);
}

void listAll(FieldList& fields, const EffecterState& effecter) {
    fields.source = "EFF " + effecter.type;
    fields.item = effecter.name;
    fields.flag("closed", effecter.closed);
    fields.flag("on", effecter.on);
    if (!effecter.tool.empty())
        fields.text("tool", effecter.tool);
    if (!effecter.tool_type.empty())
        fields.text("tool_type", effecter.tool_type);
}

void listAll(FieldList& fields, const WorldObjects& world) {
    fields.source = "STA";
    for (const WorldObject& object : world.objects) {
        fields.item = object.name;
        fields.pose(object.object_in_map);
        if (object.size_m)
            fields.vector("size", *object.size_m, "m");
        if (!object.memory.empty())
            fields.text("memory", object.memory);
    }
}

void listAll(FieldList& fields, const GeometryInfo& geometry) {
    fields.source = "GEO " + geometry.type;
    fields.item = geometry.robot_class;
    const auto listLengths = [&fields](const std::optional<Vec3>& lengths_m, std::array<std::string_view, 3> names) {
        for (std::size_t i = 0; lengths_m && i < names.size(); ++i)
            fields.number(names[i], (*lengths_m)[static_cast<Eigen::Index>(i)], "m");
    };
    listLengths(geometry.dimensions_m, {"length", "width", "height"});
    listLengths(geometry.center_of_gravity_m, {"center_x", "center_y", "center_z"});
    fields.number("wheel_radius", geometry.wheel_radius_m, "m");
    fields.number("wheel_separation", geometry.wheel_separation_m, "m");
    fields.number("wheel_base", geometry.wheel_base_m, "m");
    for (const MountedItem& mounted : geometry.items) {
        fields.item = mounted.name;
        fields.pose(mounted.item_in_mount);
        fields.text("mount", mounted.mount);
        if (mounted.tip_in_item_m)
            fields.vector("tip", *mounted.tip_in_item_m, "m");
    }
}

void listAll(FieldList& fields, const ConfigurationInfo& configuration) {
    fields.source = "CONF " + configuration.type;
    for (const ConfiguredItem& configured : configuration.items)
        for (const Setting& setting : configured.settings)
            fields.add({fields.source, configured.name, setting.key, setting.number, setting.value, {}});
}

void listAll(FieldList& fields, const Response& response) {
    fields.source = "RES " + response.type;
    fields.item = response.name;
    fields.text("status", response.ok ? "OK" : "Failed");
    fields.number("tag_id", response.tag_id);
    if (response.memory)
        fields.text("memory", *response.memory);
    for (const ResponsePart& part : response.parts) {
        fields.item = sameWord(part.key, "Name") ? part.value : part.key + " " + part.value;
        fields.number("fov", part.fov_rad, "rad");
        if (response.parts.size() > 1)
            fields.text("part_status", part.ok ? "OK" : "Failed");
    }
}

template <SensorMessage Sensor>
void listAll(FieldList& fields, const Sensor& sensor) {
    fields.source = wireTypeOf(sensor).empty() ? "SEN" : "SEN " + std::string(wireTypeOf(sensor));
    if constexpr (Described<Sensor>) {
        listDescribed(fields, sensor);
    } else {
        fields.item = sensor.name;
        list(fields, sensor);
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
    FieldList fields;
    listFields(message, fields);
    return fields.take();
}

void listFields(const InfoMessage& message, FieldList& fields) {
    fields.source.clear();
    fields.item.clear();
    std::visit([&fields](const auto& value) { listAll(fields, value); }, message);
}

std::string_view containerOf(const InfoMessage& message) {
    return std::visit([]<class Message>(const Message&) { return typeName<Message>(); }, message);
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
