#include "core/sim/robots/sensor_suite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

#include "core/base/text.h"
#include "core/sim/sensors/camera_sensor.h"

namespace usar::sim {

namespace {

constexpr std::uint64_t streams_per_robot = 256;
constexpr std::uint64_t chance_streams = std::uint64_t(1) << 40; // Beyond the streams of the sensors' noise.

struct Address {
    std::string type;
    std::string name; ///< empty: all of this type
};

/// The sensors that a SET is meant for.
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

/// UDK has no classes for these (protocol.md 4.5).
bool isUnknownToUdk(std::string_view type) {
    constexpr std::array<std::string_view, 8> unknown{"VictSensor", "RFID",   "HumanMotion", "Sound",
                                                      "CO2Sensor",  "Helper", "INU",         "GroundTruthPlayers"};
    return std::ranges::any_of(unknown, [&](std::string_view one) { return sameWord(one, type); });
}

std::uint64_t everyOf(const SensorModel& sensor, const RobotOptions& options) {
    double every = numberOr(sensor.numbers, "every", 1.0);
    if (options.profile == protocol::Dialect::Udk)
        every *= std::round(udkInterval(sensor.type) / options.scan_interval);
    return static_cast<std::uint64_t>(std::max(1.0, every));
}

bool isMeant(const SensorModel& sensor, const std::string& type, const std::string& name) {
    return sameWord(sensor.type, type) && (name.empty() || sameWord(sensor.name, name));
}

constexpr double meters_per_degree = 111'200.0; // See robots-and-worlds.md 4.8.

/// Adds the bias to anything that holds numbers.
class Bias {
public:
    explicit Bias(const Fault& fault)
        : by_(fault.number("by"))
        , shift_m_(fault.number("x"), fault.number("y"), fault.number("z"))
        , yaw_rad_(radians(fault.number("yaw_deg"))) {}

    void operator()(double& value) const { value += by_; }
    void operator()(std::vector<double>& values) const {
        for (double& value : values)
            value += by_;
    }
    void operator()(Vec3& value) const { value.array() += by_; }
    void operator()(Pose& pose) const {
        pose.position_m += shift_m_;
        pose.yaw_rad = normalizedAngle(pose.yaw_rad + yaw_rad_);
    }
    template <class Value>
    void operator()(std::optional<Value>& value) const {
        if (value)
            (*this)(*value);
    }
    void operator()(protocol::RangeScan& scan) const { (*this)(scan.ranges_m); }
    void operator()(protocol::GpsReading& gps) const { // The map's x axis points north.
        if (gps.latitude_rad && gps.longitude_rad) {
            *gps.latitude_rad += radians(shift_m_.x() / meters_per_degree);
            *gps.longitude_rad -= radians(shift_m_.y() / (meters_per_degree * std::cos(*gps.latitude_rad)));
        }
    }
    template <class Other>
    void operator()(Other&) const {}

private:
    double by_;
    Vec3 shift_m_;
    double yaw_rad_;
};

template <protocol::Described Owner>
void addTo(const Bias& bias, Owner& owner);

template <class Owner>
void addToGroups(const Bias& bias, Owner& owner) {
    if constexpr (protocol::HasGroups<Owner>)
        for (auto& element : owner.*Owner::groups().member)
            addTo(bias, element);
}

template <protocol::Described Owner>
void addTo(const Bias& bias, Owner& owner) {
    protocol::forEachItem<Owner>([&](const auto& item) { bias(owner.*(item.member)); });
    addToGroups(bias, owner);
}

/// Adds a bias: `by` to every number of the message that has a unit of its own; x, y, z and yaw_deg to positions and
/// orientations. Texts, counts, flags and times stay the same.
void addBias(const Fault& fault, protocol::InfoMessage& message) {
    const Bias bias(fault);
    std::visit(
        [&](auto& one) {
            using One = std::decay_t<decltype(one)>;
            if constexpr (protocol::SensorMessage<One> && protocol::Described<One>)
                addTo(bias, one);
            else if constexpr (protocol::SensorMessage<One>)
                bias(one);
        },
        static_cast<protocol::InfoVariant&>(message));
}

/// Sets the time of a frozen sensor's message, if it has one, to `now`.
void sayAgain(Seconds now, protocol::InfoMessage& frozen) {
    std::visit(
        [&](auto& one) {
            if constexpr (requires { one.time = now; })
                if (one.time)
                    one.time = now;
        },
        static_cast<protocol::InfoVariant&>(frozen));
}

/// Appends one sensor's message to `out`, or merges it into the last message there if that has the same type.
void addLine(protocol::InfoMessage&& message, std::vector<protocol::InfoMessage>& out) {
    const bool joined = std::visit(
        [&](auto& one) {
            using One = std::decay_t<decltype(one)>;
            if constexpr (protocol::SensorMessage<One> && protocol::NamedGroups<One>) {
                auto* const line = out.empty() ? nullptr : std::get_if<One>(&out.back());
                if (!line || protocol::wireTypeOf(*line) != protocol::wireTypeOf(one))
                    return false;
                auto& own = one.*One::groups().member;
                auto& all = line->*One::groups().member;
                all.insert(all.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
                return true;
            } else {
                return false;
            }
        },
        static_cast<protocol::InfoVariant&>(message));
    if (!joined)
        out.push_back(std::move(message));
}

} // namespace

Result<SensorSuite> SensorSuite::make(const RobotModel& robot, const RobotOptions& options) {
    SensorSuite suite;
    suite.profile_ = options.profile;
    suite.seed_ = options.seed;
    for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
        if (options.profile == protocol::Dialect::Udk && isUnknownToUdk(robot.sensors[i].type))
            continue;
        Random random = seeded(options.seed, options.number * streams_per_robot + i);
        const std::uint64_t every = everyOf(robot.sensors[i], options);
        auto sensor = makeSensor(robot.sensors[i],
                                 {robot, options.base_in_map, static_cast<double>(every) * options.scan_interval,
                                  options.noise, random, options.profile});
        if (!sensor)
            return tl::unexpected(sensor.error());
        suite.sensors_.push_back({.sensor = std::move(*sensor),
                                  .every = every,
                                  .chance_stream = chance_streams + options.number * streams_per_robot + i});
    }
    std::ranges::stable_sort(suite.sensors_, {}, [&options](const Place& place) {
        return orderOf(place.sensor->model().type, options.profile);
    });
    return suite;
}

bool SensorSuite::isDue(const Place& place, bool first) const {
    if (profile_ == protocol::Dialect::Udk)
        return (ticks_ + 1) % place.every == 0;
    return ticks_ % place.every == 0 && !(first && place.sensor->needsHistory());
}

void SensorSuite::measure(const SensorView& view, bool first, std::vector<protocol::InfoMessage>& out) {
    for (Place& place : sensors_) {
        if (!isDue(place, first))
            place.sensor->passOver(view);
        else if (place.faults.empty())
            place.sensor->measure(view, out);
        else
            measureFaulty(place, view, out);
    }
    ++ticks_;
}

void SensorSuite::measureFaulty(Place& place, const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    std::vector<protocol::InfoMessage> lines;
    place.sensor->measure(view, lines);
    bool comes = true;
    for (const Fault& fault : place.faults) {
        if (fault.kind == FaultKind::SensorFreeze) {
            if (place.frozen.empty())
                place.frozen = lines;
            lines = place.frozen;
            for (protocol::InfoMessage& line : lines)
                sayAgain(view.now, line);
        } else if (fault.kind == FaultKind::SensorDropout) {
            if (!place.chance)
                place.chance = seeded(seed_, place.chance_stream);
            comes &= uniform(*place.chance, 0.0, 1.0) >= fault.number("share");
        } else {
            for (protocol::InfoMessage& line : lines)
                addBias(fault, line);
        }
    }
    for (protocol::InfoMessage& line : lines)
        if (comes)
            addLine(std::move(line), out);
}

void SensorSuite::setFaults(const std::vector<Fault>& active) {
    for (Place& place : sensors_) {
        const SensorModel& model = place.sensor->model();
        place.faults.clear();
        for (const Fault& fault : active)
            if (descriptionOf(fault.kind).of_sensor &&
                (fault.sensor.empty() || sameWord(fault.sensor, model.name) || sameWord(fault.sensor, model.type)))
                place.faults.push_back(fault);
        if (std::ranges::none_of(place.faults, [](const Fault& one) { return one.kind == FaultKind::SensorFreeze; }))
            place.frozen.clear();
    }
}

bool SensorSuite::has(std::string_view type_or_name) const {
    return std::ranges::any_of(sensors_, [&](const Place& place) {
        return sameWord(place.sensor->model().name, type_or_name) || sameWord(place.sensor->model().type, type_or_name);
    });
}

std::vector<SeenFrom> SensorSuite::cameras(const RobotBody& body) const {
    std::vector<SeenFrom> cameras;
    for (const Place& place : sensors_)
        if (const auto* const camera = dynamic_cast<const CameraSensor*>(place.sensor.get()))
            cameras.push_back(camera->view(body));
    return cameras;
}

std::vector<const Sensor*> SensorSuite::find(const std::string& type, const std::string& name) const {
    std::vector<const Sensor*> found;
    for (const Place& place : sensors_)
        if (isMeant(place.sensor->model(), type, name))
            found.push_back(place.sensor.get());
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
        info.robot_class = name; // The bare head repeats the name that was asked for.
    return info;
}

protocol::ConfigurationInfo SensorSuite::configuration(const std::string& type, const std::string& name) const {
    protocol::ConfigurationInfo info;
    info.type = type;
    for (const Sensor* const sensor : find(type, name)) {
        info.type = sensor->model().type;
        const auto* const camera =
            profile_ == protocol::Dialect::Udk ? dynamic_cast<const CameraSensor*>(sensor) : nullptr;
        info.items.push_back({sensor->model().name, camera ? camera->udkSettings() : sensor->settings()});
    }
    if (info.items.empty() && !name.empty())
        info.items.push_back({name, {}});
    return info;
}

std::optional<protocol::Response> SensorSuite::set(const protocol::Command& command, bool at_rest) {
    const Address meant = addressOf(command);
    std::optional<protocol::Response> answer;
    for (const Place& place : sensors_) {
        if (!isMeant(place.sensor->model(), meant.type, meant.name))
            continue;
        auto one = place.sensor->set(command, at_rest);
        if (one && (!answer || !one->ok))
            answer = std::move(one);
    }
    return answer;
}

} // namespace usar::sim
