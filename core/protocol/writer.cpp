#include "core/protocol/writer.h"

#include <algorithm>
#include <string_view>

#include "core/base/text.h"
#include "core/protocol/described_writer.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"
#include "core/protocol/writer_parts.h"

namespace usar::protocol {

namespace {

void writeSegments(LineWriter& line, const std::vector<KeyValue>& segments) {
    for (const KeyValue& segment : segments) {
        line.text(" {");
        line.text(segment.key);
        line.text(segment.value.empty() ? "" : " ");
        line.text(segment.value);
        line.close();
    }
}

void writeInto(LineWriter& line, const GenericMessage& message) {
    line.text(message.type_word);
    writeSegments(line, message.segments);
}

void writeInto(LineWriter& line, const GameInfo& game) {
    line.text("NFO");
    line.segment("Gametype", game.game_type);
    line.segment("Level", game.level);
    line.whole("TimeLimit", game.time_limit_min);
}

void writeInto(LineWriter& line, const StartPoses& start) {
    writePlaces(line, "StartPoses", start.poses, Decimals::TwoRounded);
}

void writeInto(LineWriter& line, const PathNodes& path) {
    writePlaces(line, "PathNodes", path.nodes, Decimals::TwoRounded);
}

void writeInto(LineWriter& line, const ClosestPathNode& node) {
    line.text("NFO");
    line.segment("Pathnode", node.name);
    line.segment("Location", acrossWire(node.position_in_map_m), Decimals::FourCut);
}

void writeInto(LineWriter& line, const LockstepInfo& lockstep) {
    line.text("NFO");
    line.boolean("Lockstep", lockstep.on);
}

void writeInto(LineWriter& line, const RobotState& state) {
    line.text("STA");
    if (state.kind != VehicleKind::Unknown)
        line.segment("Type", wordOf(state.kind));
    line.time(state.time, Decimals::TwoRounded);
    writeSteering(line, state);
    writeJoints(line, state);
    line.boolean("LightToggle", state.light_on);
    line.whole("LightIntensity", state.light_intensity_pct);
    writeBattery(line, state);
    line.whole("View", state.view);
    writeSegments(line, state.others);
}

void writeInto(LineWriter& line, const PackageState& package) {
    line.text("MISSTA");
    line.time(package.time, Decimals::TwoRounded);
    writeDescribed(line, package);
}

void writeInto(LineWriter& line, const EffecterState& effecter) {
    line.text("EFF");
    line.time(effecter.time, Decimals::FourCut);
    line.segment("Type", effecter.type);
    line.segment("Name", effecter.name);
    if (effecter.closed)
        line.segment("Status", *effecter.closed ? "CLOSED" : "OPEN");
    if (effecter.on)
        line.text(*effecter.on ? " {On}" : " {Off}");
    line.segmentIfAny("ToolType", effecter.tool_type);
    line.segmentIfAny("Tool", effecter.tool);
}

/// Writes correct braces, unlike the original server: nobody needs its malformed ones.
void writeInto(LineWriter& line, const WorldObjects& world) {
    line.text("STA");
    for (const WorldObject& object : world.objects) {
        const Pose on_wire = acrossWire(object.object_in_map);
        line.segment("Name", object.name);
        line.segment("Size", object.size_m, Decimals::FourCut);
        line.segment("Location", on_wire.position_m, Decimals::FourCut);
        line.segmentIfAny("Memory", object.memory);
        line.segment("Rotation", anglesOf(on_wire), Decimals::FourCut);
    }
}

/// Sensors without a description have a write function of their own. Only the range scanner prints its time as a bare
/// float.
template <SensorMessage Sensor>
void writeInto(LineWriter& line, const Sensor& sensor) {
    if constexpr (Described<Sensor>) {
        line.sensor(sensor.time, wireTypeOf(sensor));
        writeDescribed(line, sensor);
    } else {
        write(line, sensor);
    }
}

void writeItem(LineWriter& line, const MountedItem& item) {
    const Pose on_wire = acrossWire(item.item_in_mount);
    line.open("Name");
    line.text(item.name);
    line.text(" Location ");
    line.numbers(on_wire.position_m, Decimals::FourCut);
    line.text(" Orientation ");
    line.numbers(anglesOf(on_wire), Decimals::FourCut);
    if (!item.mount.empty()) {
        line.text(" Mount ");
        line.text(item.mount);
    }
    line.close();
    if (item.tip_in_item_m)
        line.segment("Tip", acrossWire(*item.tip_in_item_m), Decimals::FourCut);
}

/// Writes the links of mission packages as UT2004 numbers them: "CameraPanTilt_Link2" mounted on "CameraPanTilt_Link1"
/// is link 2 of "CameraPanTilt" with parent link 1.
void writeLinks(LineWriter& line, const std::vector<MountedItem>& links) {
    constexpr std::string_view mark = "_Link";
    std::string_view package;
    for (const MountedItem& link : links) {
        const std::string_view name = link.name;
        const std::size_t at = std::min(name.rfind(mark), name.size());
        if (name.substr(0, at) != package) {
            package = name.substr(0, at);
            line.segment("Name", package);
        }
        const std::size_t parent = link.mount.rfind(mark);
        const Pose on_wire = acrossWire(link.item_in_mount);
        line.segment("Link", name.substr(std::min(at + mark.size(), name.size())));
        line.segment("ParentLink", parent == std::string::npos ? "-1" : link.mount.substr(parent + mark.size()));
        line.segment("Location", on_wire.position_m, Decimals::FourCut);
        line.segment("Orientation", anglesOf(on_wire), Decimals::FourCut);
    }
}

void writeInto(LineWriter& line, const GeometryInfo& geometry) {
    line.text("GEO");
    line.segmentIfAny("Type", geometry.type);
    line.segmentIfAny("Name", geometry.robot_class);
    line.segment("Dimensions", geometry.dimensions_m, Decimals::FourCut);
    if (geometry.center_of_gravity_m)
        line.segment("COG", acrossWire(*geometry.center_of_gravity_m), Decimals::FourCut);
    line.segment("WheelRadius", geometry.wheel_radius_m, Decimals::FourCut);
    line.segment("WheelSeparation", geometry.wheel_separation_m, Decimals::FourCut);
    line.segment("WheelBase", geometry.wheel_base_m, Decimals::FourCut);
    if (sameWord(geometry.type, "MisPkg"))
        return writeLinks(line, geometry.items);
    for (const MountedItem& item : geometry.items)
        writeItem(line, item);
}

void writeInto(LineWriter& line, const ConfigurationInfo& configuration) {
    line.text("CONF");
    line.segmentIfAny("Type", configuration.type);
    for (const ConfiguredItem& item : configuration.items) {
        line.segment("Name", item.name);
        for (const Setting& setting : item.settings)
            writeSetting(line, setting.key, setting);
    }
}

void writeInto(LineWriter& line, const Response& response) {
    line.text("RES");
    line.time(response.time, Decimals::TwoRounded);
    line.segment("Type", response.type);
    for (const ResponsePart& part : response.parts) {
        line.segment(part.key, part.value);
        line.segment("FOV", part.fov_rad, Decimals::FourCut);
        line.segment("Status", part.ok ? "OK" : "Failed");
    }
    if (response.parts.empty()) {
        line.segment("Name", response.name);
        const bool of_tags = std::string_view(response.type).starts_with("RFID"); // protocol.md 4.8
        line.segment(of_tags ? "status" : "Status", response.ok ? "OK" : "Failed");
    }
    line.whole("ID", response.tag_id);
    if (response.memory)
        line.segment("Mem", *response.memory);
}

} // namespace

void write(const InfoMessage& message, std::string& out) {
    LineWriter line(out);
    std::visit([&line](const auto& value) { writeInto(line, value); }, message);
}

} // namespace usar::protocol
