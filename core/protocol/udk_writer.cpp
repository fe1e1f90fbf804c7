#include "core/protocol/writer.h"

#include <type_traits>

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

/// UDK sends time and battery first, no Type for a flying robot, and always the full light intensity. The angles of a
/// robot that cannot steer are whole numbers.
void writeInto(const Context& context, const RobotState& state) {
    LineWriter line(context.out);
    line.text("STA");
    line.time(state.time.value_or(context.now), Decimals::FourCut);
    writeBattery(line, state);
    if (state.kind == VehicleKind::Legged)
        line.segment("Type", "LeggedVehicle");
    else if (state.kind != VehicleKind::Unknown && state.kind != VehicleKind::Aerial)
        line.segment("Type", wordOf(state.kind));
    if (state.light_on && state.kind != VehicleKind::Aerial) {
        line.boolean("LightToggle", *state.light_on);
        line.whole("LightIntensity", 100);
    }
    if (context.robot.steers || state.front_steer_rad.value_or(0.0) != 0.0 ||
        state.rear_steer_rad.value_or(0.0) != 0.0) {
        writeSteering(line, state);
    } else {
        line.whole("FrontSteer", state.front_steer_rad);
        line.whole("RearSteer", state.rear_steer_rad);
    }
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

/// Writes where an item is mounted. UDK names an actuator and its link apart; UT2004 says "TeleMaxArm_Link3".
void writeMount(LineWriter& line, const MountedItem& item, const UdkRobot& robot) {
    constexpr std::string_view mark = "_Link";
    const std::string_view mount = item.mount;
    const std::size_t at = mount.rfind(mark);
    if (at == std::string_view::npos) {
        line.segment("Mount", sameWord(mount, "HARD") ? std::string_view(robot.class_name) : mount);
    } else {
        line.segment("Mount", mount.substr(0, at));
        line.segment("MountLink", mount.substr(at + mark.size()));
    }
    if (item.tip_in_item_m)
        line.segment("Tip", acrossWire(*item.tip_in_item_m), Decimals::TwoRounded);
}

void writeInto(const Context& context, const GeometryInfo& geometry) {
    if (geometry.items.empty() && !geometry.dimensions_m)
        return;
    if (geometry.items.empty())
        return write(geometry, context.out); // a robot's geometry, which is the same in UT2004
    LineWriter line(context.out);
    line.text("GEO");
    line.segment("Type", geometry.type);
    for (const MountedItem& item : geometry.items) {
        const Pose on_wire = acrossWire(item.item_in_mount);
        line.segment("Name", item.name);
        line.segment("Location", on_wire.position_m, Decimals::TwoRounded);
        line.segment("Orientation", anglesOf(on_wire), Decimals::TwoRounded);
        writeMount(line, item, context.robot);
    }
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
    if (configuration.items.empty() || configuration.items.front().settings.empty())
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
            writeSetting(line, setting.key == "Paning" ? "Panning" : std::string_view(setting.key), setting);
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
