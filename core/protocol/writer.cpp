#include "core/protocol/writer.h"

#include <cmath>
#include <string_view>

#include "core/protocol/line_writer.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

Vec3 anglesOf(const Pose& on_wire) {
    return {on_wire.roll_rad, on_wire.pitch_rad, on_wire.yaw_rad};
}

/// The same angles in [0, 2 pi), as UT2004's ground truth and INS have them.
Vec3 positiveAnglesOf(const Pose& on_wire) {
    return anglesOf(on_wire).unaryExpr([](double angle_rad) { return angle_rad < 0 ? angle_rad + 2 * pi : angle_rad; });
}

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
    if (game.time_limit_min)
        line.whole("TimeLimit", *game.time_limit_min);
}

void writeInto(LineWriter& line, const StartPoses& start) {
    line.text("NFO");
    line.whole("StartPoses", static_cast<long long>(start.poses.size()));
    for (std::size_t i = 0; i < start.poses.size(); ++i) {
        const Pose on_wire = acrossWire(start.poses[i].pose_in_map);
        line.text(i == 0 ? " {" : " ");
        line.text(start.poses[i].name);
        line.text(" ");
        line.numbers(on_wire.position_m, Decimals::TwoRounded);
        line.text(" ");
        line.numbers(anglesOf(on_wire), Decimals::TwoRounded);
    }
    if (!start.poses.empty())
        line.close();
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
    if (state.front_steer_rad)
        line.segment("FrontSteer", acrossWire(*state.front_steer_rad), Decimals::FourCut);
    if (state.rear_steer_rad)
        line.segment("RearSteer", acrossWire(*state.rear_steer_rad), Decimals::FourCut);
    for (const JointAngle& joint : state.joints)
        line.segment(joint.name, joint.angle_rad, Decimals::FourCut);
    if (state.light_on)
        line.boolean("LightToggle", *state.light_on);
    if (state.light_intensity_pct)
        line.whole("LightIntensity", *state.light_intensity_pct);
    if (state.battery_left)
        line.whole("Battery", static_cast<long long>(std::floor(state.battery_left->count())));
    if (state.view)
        line.whole("View", *state.view);
    writeSegments(line, state.others);
}

void writeInto(LineWriter& line, const SonarReadings& sonars) {
    line.text("SEN");
    line.time(sonars.time, Decimals::FourCut);
    line.segment("Type", "Sonar");
    for (const NamedRange& sonar : sonars.ranges) {
        line.open("Name");
        line.text(sonar.name);
        line.text(" Range ");
        line.number(sonar.range_m, Decimals::FourCut);
        line.close();
    }
}

void writeInto(LineWriter& line, const RangeScan& scan) {
    line.text("SEN");
    line.time(scan.time, Decimals::TwoRounded);
    if (!scan.type.empty())
        line.segment("Type", scan.type);
    line.segment("Name", scan.name);
    line.segment("Resolution", scan.resolution_rad, Decimals::FourCut);
    line.segment("FOV", scan.fov_rad, Decimals::FourCut);
    line.open("Range");
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        if (i > 0)
            line.text(",");
        line.number(scan.ranges_m[i], Decimals::FourCut);
    }
    line.close();
}

void writePoseSensor(LineWriter& line, std::string_view type, const std::optional<Seconds>& time, std::string_view name,
                     const Pose& base_in_map) {
    const Pose on_wire = acrossWire(base_in_map);
    line.text("SEN");
    line.time(time, Decimals::FourCut);
    line.segment("Type", type);
    line.segment("Name", name);
    line.segment("Location", on_wire.position_m, Decimals::TwoRounded);
    line.segment("Orientation", positiveAnglesOf(on_wire), Decimals::TwoRounded);
}

void writeInto(LineWriter& line, const InsReading& reading) {
    writePoseSensor(line, "INS", reading.time, reading.name, reading.base_in_map);
}

void writeInto(LineWriter& line, const GroundTruthReading& reading) {
    writePoseSensor(line, "GroundTruth", reading.time, reading.name, reading.base_in_map);
}

void writeInto(LineWriter& line, const OdometryReading& reading) {
    line.text("SEN");
    line.time(reading.time, Decimals::FourCut);
    line.segment("Type", "Odometry");
    if (!reading.name.empty())
        line.segment("Name", reading.name);
    if (!reading.base_in_start)
        return;
    const Pose on_wire = acrossWire(*reading.base_in_start);
    line.segment("Pose", {on_wire.position_m.x(), on_wire.position_m.y(), on_wire.yaw_rad}, Decimals::FourCut);
}

void writeInto(LineWriter& line, const EncoderReadings& readings) {
    line.text("SEN");
    line.time(readings.time, Decimals::FourCut);
    line.segment("Type", "Encoder");
    for (const EncoderTicks& encoder : readings.encoders)
        line.segment("Name", encoder.name + " Tick " + std::to_string(encoder.ticks));
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
}

void writeInto(LineWriter& line, const GeometryInfo& geometry) {
    line.text("GEO");
    if (!geometry.type.empty())
        line.segment("Type", geometry.type);
    if (!geometry.robot_class.empty())
        line.segment("Name", geometry.robot_class);
    if (geometry.dimensions_m)
        line.segment("Dimensions", *geometry.dimensions_m, Decimals::FourCut);
    if (geometry.center_of_gravity_m)
        line.segment("COG", acrossWire(*geometry.center_of_gravity_m), Decimals::FourCut);
    if (geometry.wheel_radius_m)
        line.segment("WheelRadius", *geometry.wheel_radius_m, Decimals::FourCut);
    if (geometry.wheel_separation_m)
        line.segment("WheelSeparation", *geometry.wheel_separation_m, Decimals::FourCut);
    if (geometry.wheel_base_m)
        line.segment("WheelBase", *geometry.wheel_base_m, Decimals::FourCut);
    for (const MountedItem& item : geometry.items)
        writeItem(line, item);
}

void writeInto(LineWriter& line, const ConfigurationInfo& configuration) {
    line.text("CONF");
    if (!configuration.type.empty())
        line.segment("Type", configuration.type);
    for (const ConfiguredItem& item : configuration.items) {
        line.segment("Name", item.name);
        for (const Setting& setting : item.settings) {
            if (setting.value.empty() && setting.number)
                line.segment(setting.key, *setting.number, Decimals::FourCut);
            else
                line.segment(setting.key, setting.value);
        }
    }
}

void writeInto(LineWriter& line, const Response& response) {
    line.text("RES");
    line.time(response.time, Decimals::TwoRounded);
    line.segment("Type", response.type);
    line.segment("Name", response.name);
    line.segment("Status", response.ok ? "OK" : "Failed");
}

} // namespace

void write(const InfoMessage& message, std::string& out) {
    LineWriter line(out);
    std::visit([&line](const auto& value) { writeInto(line, value); }, message);
}

} // namespace usar::protocol
