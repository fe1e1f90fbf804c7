#include "core/protocol/writer.h"

#include <type_traits>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/described_writer.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"
#include "core/protocol/writer_parts.h"

namespace usar::protocol {

namespace {

constexpr std::string_view line_end = "\r\n";

/// The output text, to which one line without its end is added, and the values that messages do not carry themselves.
struct Context {
    std::string& out;
    Seconds now;
    const UdkRobot& robot;
};

/// Writes a line for each of the sensors that UT2004 puts into one line.
template <NamedGroups Sensor>
void writeInto(const Context& context, const Sensor& sensor) {
    const auto& elements = sensor.*Sensor::groups().member;
    LineWriter line(context.out);
    for (const auto& element : elements) {
        line.text(&element == &elements.front() ? "" : line_end);
        line.sensor(sensor.time.value_or(context.now), wireTypeOf(sensor));
        line.segment("Name", element.name);
        writeItems(line, element);
    }
}

template <class Sensor>
requires(SensorMessage<Sensor>&& Described<Sensor> && !NamedGroups<Sensor>) void writeInto(const Context& context,
                                                                                           const Sensor& sensor) {
    LineWriter line(context.out);
    std::optional<Seconds> time = sensor.time.value_or(context.now);
    if constexpr (std::is_same_v<Sensor, InsReading>)
        time.reset();
    line.sensor(time, wireTypeOf(sensor));
    writeDescribed(line, sensor);
}

/// UT2004's angles of ground truth are in [0, 2 pi), UDK's in (-pi, pi].
void writeInto(const Context& context, const GroundTruthReading& truth) {
    LineWriter line(context.out);
    line.sensor(truth.time.value_or(context.now), GroundTruthReading::wire_types);
    line.segment("Name", truth.name);
    writeItem(line, truth, pose(&GroundTruthReading::base_in_map, false), false);
}

/// With a position there is no space before Fix.
void writeInto(const Context& context, const GpsReading& gps) {
    GpsReading timed = gps;
    timed.time = gps.time.value_or(context.now);
    const std::size_t begin = context.out.size();
    LineWriter line(context.out);
    write(line, timed);
    if (const std::size_t fix = context.out.find("} {Fix", begin); gps.latitude_rad && fix != std::string::npos)
        context.out.erase(fix + 1, 1);
}

void writeInto(const Context& context, const StartPoses& start) {
    LineWriter line(context.out);
    writePlaces(line, "StartPoses", start.poses, Decimals::FourCut);
}

void writeInto(const Context& context, const RangeScan& scan) {
    LineWriter line(context.out);
    line.sensor(scan.time.value_or(context.now), scan.type);
    writeScan(line, scan, Decimals::TwoRounded);
}

/// The angle of an axle that cannot steer is the constant 0, a whole number.
void writeSteer(LineWriter& line, std::string_view key, const std::optional<double>& angle_rad, bool steers) {
    if (angle_rad && (steers || *angle_rad != 0.0))
        line.segment(key, acrossWire(*angle_rad), Decimals::FourCut);
    else
        line.whole(key, angle_rad);
}

/// UDK sends time and battery first, no Type for a flying robot, and always the full light intensity. Only ground
/// vehicles tell of their lights.
void writeInto(const Context& context, const RobotState& state) {
    LineWriter line(context.out);
    line.text("STA");
    line.time(state.time.value_or(context.now), Decimals::FourCut);
    writeBattery(line, state);
    if (state.kind == VehicleKind::Legged)
        line.segment("Type", "LeggedVehicle");
    else if (state.kind != VehicleKind::Unknown && state.kind != VehicleKind::Aerial)
        line.segment("Type", wordOf(state.kind));
    if (state.light_on && state.kind == VehicleKind::Ground) {
        line.boolean("LightToggle", *state.light_on);
        line.whole("LightIntensity", 100);
    }
    writeSteer(line, "FrontSteer", state.front_steer_rad, context.robot.steers_front);
    writeSteer(line, "RearSteer", state.rear_steer_rad, context.robot.steers_rear);
    writeJoints(line, state);
}

void writeInto(const Context& context, const PackageState& package) {
    LineWriter line(context.out);
    line.text("ASTA");
    line.time(package.time.value_or(context.now), Decimals::FourCut);
    line.segment("Name", package.name);
    for (const LinkState& link : package.links) {
        line.whole("Link", link.link);
        line.segment("Value", link.value, Decimals::FourCut);
    }
}

/// The package and the number of a link: "TeleMaxArm" and "3" of "TeleMaxArm_Link3". The number is empty for what is
/// no link.
std::pair<std::string_view, std::string_view> linkNameOf(std::string_view name) {
    constexpr std::string_view mark = "_Link";
    const std::size_t at = name.rfind(mark);
    if (at == std::string_view::npos)
        return {name, {}};
    return {name.substr(0, at), name.substr(at + mark.size())};
}

/// Writes where an item is mounted. UDK names an actuator and its link apart; UT2004 says "TeleMaxArm_Link3".
void writeMount(LineWriter& line, std::string_view mount, const UdkRobot& robot) {
    const auto [part, link] = linkNameOf(mount);
    line.segment("Mount", sameWord(part, "HARD") ? std::string_view(robot.class_name) : part);
    line.segmentIfAny("MountLink", link);
}

void writeTip(LineWriter& line, const MountedItem& item) {
    if (item.tip_in_item_m)
        line.segment("Tip", acrossWire(*item.tip_in_item_m), Decimals::TwoRounded);
}

void writePose(LineWriter& line, const Pose& pose) {
    const Pose on_wire = acrossWire(pose);
    line.segment("Location", on_wire.position_m, Decimals::TwoRounded);
    line.segment("Orientation", anglesOf(on_wire), Decimals::TwoRounded);
}

/// Writes actuators: each has a base, which is link 0 and has its place on the robot, and links that are numbered from
/// 1. Our packages have no base of their own, so it is where their first link is.
void writeActuators(LineWriter& line, const std::vector<MountedItem>& links, const UdkRobot& robot) {
    for (const MountedItem& link : links) {
        const auto [actuator, number] = linkNameOf(link.name);
        const std::string_view parent = linkNameOf(link.mount).second;
        if (parent.empty()) {
            line.segment("Name", actuator);
            writePose(line, link.item_in_mount);
            writeMount(line, link.mount, robot);
        }
        line.segment("Link", number);
        line.segment("Parent", parent.empty() ? "0" : parent);
        writePose(line, parent.empty() ? Pose{} : link.item_in_mount);
        writeTip(line, link);
    }
}

/// Servers print zeros with either sign here, as they come.
void writeInto(const Context& context, const GeometryInfo& geometry) {
    if (geometry.items.empty() && !geometry.dimensions_m)
        return;
    if (geometry.items.empty())
        return write(geometry, context.out); // a robot's geometry, which is the same in UT2004
    LineWriter line(context.out, NegativeZero::Shown);
    line.text("GEO");
    line.segment("Type", geometry.type);
    if (sameWord(geometry.type, "Actuator") || sameWord(geometry.type, "MisPkg"))
        return writeActuators(line, geometry.items, context.robot);
    for (const MountedItem& item : geometry.items) {
        line.segment("Name", item.name);
        writePose(line, item.item_in_mount);
        writeMount(line, item.mount, context.robot);
        writeTip(line, item);
    }
}

/// Writes a setting of UT2004 under UDK's name for it. The speed of an actuator is not told, and the steering angle of
/// an axle that cannot steer is the constant 0, a whole number.
void writeUdkSetting(LineWriter& line, std::string_view type, const Setting& setting) {
    const bool of_actuator = sameWord(type, "Actuator");
    const std::string_view key = setting.key;
    if (of_actuator && key == "MaxSpeed")
        return;
    if (key.ends_with("Steer") && setting.number == 0.0)
        return line.whole(key, 0);
    const bool is_limit = of_actuator && (key == "MinRange" || key == "MaxRange");
    writeSetting(line,
                 is_limit          ? (key == "MinRange" ? "MinValue" : "MaxValue")
                 : key == "Paning" ? "Panning"
                                   : key,
                 setting);
}

/// UDK's camera answers with no space between its name and its settings.
void writeCameraSettings(std::string& out, const ConfiguredItem& camera) {
    for (const Setting& setting : camera.settings) {
        const std::size_t space = out.size();
        LineWriter line(out);
        writeSetting(line, setting.key, setting);
        out.erase(space, 1);
    }
}

void writeInto(const Context& context, const ConfigurationInfo& configuration) {
    const bool is_old_question = sameWord(configuration.type, "MisPkg"); // It is answered in any case.
    if (configuration.items.empty() ? !is_old_question : configuration.items.front().settings.empty())
        return;
    const bool of_robot = vehicleKindOf(configuration.type) != VehicleKind::Unknown;
    LineWriter line(context.out);
    line.text("CONF");
    if (of_robot)
        line.segment("Name", configuration.items.front().name);
    line.segment("Type", configuration.type);
    for (const ConfiguredItem& item : configuration.items) {
        if (!of_robot)
            line.segment("Name", item.name);
        if (sameWord(configuration.type, "Camera")) {
            writeCameraSettings(context.out, item);
            continue;
        }
        for (const Setting& setting : item.settings)
            writeUdkSetting(line, configuration.type, setting);
    }
}

void writeInto(const Context&, const Response&) {}

/// Messages that are the same in both dialects.
template <class Message>
requires(!(SensorMessage<Message> && Described<Message>)) void writeInto(const Context& context,
                                                                         const Message& message) {
    write(message, context.out);
}

} // namespace

void writeUdk(const InfoMessage& message, Seconds now, const UdkRobot& robot, std::string& out) {
    const Context context{out, now, robot};
    const std::size_t before = out.size();
    std::visit([&context](const auto& value) { writeInto(context, value); }, static_cast<const InfoVariant&>(message));
    if (out.size() > before)
        out += line_end;
}

} // namespace usar::protocol
