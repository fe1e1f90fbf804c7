#include "core/sim/robots/sensor_suite.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr std::uint64_t streams_per_robot = 256;

struct Address {
    std::string type;
    std::string name; ///< empty: all of the type
};

/// Whom a SET is meant for.
Address addressOf(const protocol::Command& command) {
    return std::visit(
        [](const auto& one) -> Address {
            using One = std::decay_t<decltype(one)>;
            if constexpr (std::is_same_v<One, protocol::SetInsPose>)
                return {"INS", one.sensor_name};
            else if constexpr (std::is_same_v<One, protocol::ReadTag> || std::is_same_v<One, protocol::WriteTag>)
                return {"RFID", one.reader_name};
            else if constexpr (std::is_same_v<One, protocol::ZoomCamera>)
                return {"Camera", one.camera_name};
            else if constexpr (std::is_same_v<One, protocol::ResetSensor> || std::is_same_v<One, protocol::ScanNow>)
                return {one.type, one.sensor_name};
            else if constexpr (std::is_same_v<One, protocol::SetItem>)
                return {one.type, one.item_name};
            else
                return {};
        },
        static_cast<const protocol::CommandVariant&>(command));
}

Seconds udkInterval(std::string_view type) {
    if (sameWord(type, "GroundTruth") || sameWord(type, "Odometry"))
        return Seconds{0.1};
    return sameWord(type, "GPS") ? Seconds{0.5} : Seconds{0.2};
}

std::uint64_t everyOf(const SensorModel& sensor, const SuiteBirth& birth) {
    double every = numberOr(sensor.numbers, "every", 1.0);
    if (birth.profile == protocol::Dialect::Udk)
        every *= std::round(udkInterval(sensor.type) / birth.scan_interval);
    return static_cast<std::uint64_t>(std::max(1.0, every));
}

bool isMeant(const SensorModel& sensor, const std::string& type, const std::string& name) {
    return sameWord(sensor.type, type) && (name.empty() || sameWord(sensor.name, name));
}

} // namespace

Result<SensorSuite> SensorSuite::make(const RobotModel& robot, const SuiteBirth& birth) {
    SensorSuite suite;
    for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
        Random random = seeded(birth.seed, birth.robot_number * streams_per_robot + i);
        auto sensor =
            makeSensor(robot.sensors[i], {robot, birth.base_in_map, birth.scan_interval, birth.noise, random});
        if (!sensor)
            return tl::unexpected(sensor.error());
        suite.sensors_.push_back({std::move(*sensor), everyOf(robot.sensors[i], birth)});
    }
    std::ranges::stable_sort(suite.sensors_, {},
                             [](const Place& place) { return orderOf(place.sensor->model().type); });
    return suite;
}

void SensorSuite::measure(const SensorView& view, bool first, std::vector<protocol::InfoMessage>& out) {
    for (const auto& [sensor, every] : sensors_)
        if ((!first || !sensor->needsHistory()) && ticks_ % every == 0)
            sensor->measure(view, out);
    ++ticks_;
}

std::vector<const Sensor*> SensorSuite::find(const std::string& type, const std::string& name) const {
    std::vector<const Sensor*> found;
    for (const auto& [sensor, every] : sensors_)
        if (isMeant(sensor->model(), type, name))
            found.push_back(sensor.get());
    return found;
}

protocol::GeometryInfo SensorSuite::geometry(const std::string& type, const std::string& name) const {
    protocol::GeometryInfo info;
    info.type = type;
    for (const Sensor* const sensor : find(type, name)) {
        const SensorModel& model = sensor->model();
        info.type = model.type;
        info.items.push_back({model.name, model.sensor_in_link, model.mount, {}});
    }
    if (info.items.empty())
        info.robot_class = name; // the bare head repeats the name that was asked for
    return info;
}

protocol::ConfigurationInfo SensorSuite::configuration(const std::string& type, const std::string& name) const {
    protocol::ConfigurationInfo info;
    info.type = type;
    for (const Sensor* const sensor : find(type, name)) {
        info.type = sensor->model().type;
        info.items.push_back({sensor->model().name, sensor->settings()});
    }
    if (info.items.empty() && !name.empty())
        info.items.push_back({name, {}});
    return info;
}

std::optional<protocol::Response> SensorSuite::set(const protocol::Command& command, bool at_rest) {
    const Address meant = addressOf(command);
    std::optional<protocol::Response> answer;
    for (const auto& [sensor, every] : sensors_) {
        if (!isMeant(sensor->model(), meant.type, meant.name))
            continue;
        auto one = sensor->set(command, at_rest);
        if (one && (!answer || !one->ok))
            answer = std::move(one);
    }
    return answer;
}

} // namespace usar::sim
