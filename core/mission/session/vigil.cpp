#include "core/mission/session/vigil.h"

#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::mission {

namespace {

bool isWatched(std::string_view type) {
    return !type.empty() && protocol::speaksAlways(type);
}

/// The first lines of a tick may come before the first one that contains the server's time, which may be hours.
constexpr Seconds clock_unknown{0.0};

/// Sensors of which a robot has only one, whatever its name.
template <class Sensor>
constexpr bool is_alone =
    std::is_same_v<Sensor, protocol::InsReading> || std::is_same_v<Sensor, protocol::GroundTruthReading> ||
    std::is_same_v<Sensor, protocol::OdometryReading>;

bool tellsSomething(const protocol::NamedRange& range) {
    return !std::isnan(range.range_m);
}
bool tellsSomething(const auto&) {
    return true;
}

/// Calls `speak(type, name)` for each sensor that has a reading in the message.
template <class Speak>
struct Speakers {
    const Speak& speak;

    template <protocol::SensorMessage Sensor>
    void operator()(const Sensor& message) const {
        const std::string_view type = protocol::wireTypeOf(message);
        if (!isWatched(type))
            return;
        protocol::forEachReading(message, [&](const std::string& name, const auto& reading) {
            if (tellsSomething(reading))
                speak(type, is_alone<Sensor> ? std::string_view() : std::string_view(name));
        });
    }
    /// A damaged line of a known type could come from any sensor, so only unknown types count here.
    void operator()(const protocol::GenericMessage& message) const {
        if (sameWord(message.type_word, "SEN") && isWatched(message.type) && !protocol::isKnownSensor(message.type))
            speak(message.type, message.name);
    }
    void operator()(const auto&) const {}
};

bool passed(const std::optional<Seconds>& since, Seconds limit, Seconds wall) {
    return since && wall - *since > limit;
}

} // namespace

std::vector<std::string> SensorWatch::saw(const protocol::InfoMessage& message, Seconds now) {
    std::vector<std::string> back;
    const auto speak = [&](std::string_view type, std::string_view name) {
        key_ = type;
        if (!name.empty() && name != type)
            (key_ += ' ') += name;
        auto sensor = sensors_.find(key_);
        if (sensor == sensors_.end()) {
            if (sensors_.size() >= sensor_limit)
                return;
            sensor = sensors_.emplace(key_, Seen{}).first;
        }
        if (sensor->second.reported)
            back.push_back(key_);
        sensor->second = Seen{.last = now};
    };
    std::visit(Speakers<decltype(speak)>{speak}, message);
    return back;
}

std::vector<std::string> SensorWatch::newlySilent(Seconds now) {
    std::vector<std::string> silent;
    for (auto& [name, sensor] : sensors_) {
        if (sensor.last == clock_unknown)
            sensor.last = now;
        if (sensor.reported || now - sensor.last <= limit_)
            continue;
        sensor.reported = true;
        silent.push_back(name);
    }
    return silent;
}

void Vigil::setLimits(const SessionLimits& limits) {
    limits_ = limits;
    sensors_ = SensorWatch(limits.sensor_silence);
}

void Vigil::beginConnection() {
    sensors_.reset();
    earlier_times_ = 0;
    start_poses_settled_ = silence_said_ = false;
}

void Vigil::heardStartPoses() {
    start_poses_settled_ = true;
    notices_.over(Topic::StartPoses, "The start poses have arrived after all.");
}

void Vigil::heardRobot(const protocol::InfoMessage& message, const std::string& robot_name, Seconds now, Seconds wall) {
    for (const std::string& name : sensors_.saw(message, now))
        notices_.over(Topic::Sensor, name + " is sending again.", name);
    heard_at_ = wall;
    if (std::exchange(silence_said_, false))
        notices_.over(Topic::Silence, robot_name + " is sending again.");
    if (const auto* const state = std::get_if<protocol::RobotState>(&message); state && state->time)
        heardTime(*state->time, now);
}

/// A single earlier time may be a damaged line or one that was late.
void Vigil::heardTime(Seconds time, Seconds now) {
    constexpr int many = 3;
    constexpr Seconds rounding{0.5};
    earlier_times_ = time < now - rounding ? earlier_times_ + 1 : 0;
    if (earlier_times_ == many)
        notices_.trouble(Severity::Warning, Topic::Clock,
                         "The server's time went back from " + fixed(now.count(), 1) + " s to " +
                             fixed(time.count(), 1) + " s. Behaviors wait until it passes " + fixed(now.count(), 1) +
                             " s. Was the server's level restarted? Then stop the robot and connect again.");
    else if (earlier_times_ == 0)
        notices_.over(Topic::Clock, "The server's time goes on from where it had been.");
}

void Vigil::expectSilence(bool expected, Seconds wall) {
    if (silence_expected_ && !expected && heard_at_)
        forgive(wall);
    silence_expected_ = expected;
}

std::optional<Seconds> Vigil::silentFor(Seconds wall) const {
    return heard_at_ ? std::optional(wall - *heard_at_) : std::nullopt;
}

void Vigil::lookForStartPoses(Seconds wall) {
    if (start_poses_settled_ || !passed(connected_at_, limits_.greeting, wall))
        return;
    start_poses_settled_ = true;
    notices_.trouble(Severity::Warning, Topic::StartPoses,
                     "No start poses from the server for " + spanText(limits_.greeting) +
                         ". Is it USARSim, and is its game running? A robot can still be spawned at "
                         "a typed pose.");
}

void Vigil::lookForRobot(const std::string& robot_name, Seconds wall) {
    if (silence_said_ || silence_expected_ || !passed(heard_at_, limits_.stale, wall))
        return;
    silence_said_ = true;
    notices_.trouble(Severity::Warning, Topic::Silence,
                     "Nothing from " + robot_name + " for " + spanText(limits_.stale) +
                         ": its values are stale. Is the simulation paused, or the network down?");
}

void Vigil::lookForSensors(Seconds now, bool battery_is_empty) {
    for (const std::string& name : sensors_.newlySilent(now))
        notices_.trouble(Severity::Warning, Topic::Sensor,
                         "No reading from " + name + " for " + spanText(limits_.sensor_silence) +
                             " of the robot's time; the last value stays, marked as old. " +
                             (battery_is_empty ? "The battery is empty." : "Stop the robot if it needs this sensor."),
                         name);
}

void Vigil::lookAtQueue(std::size_t unsent_bytes, const std::string& place) {
    if (unsent_bytes > limits_.unsent_bytes && !notices_.stands(Topic::Queue))
        notices_.trouble(
            Severity::Warning, Topic::Queue,
            "The server at " + place +
                " reads more slowly than commands are sent: " + fixed(static_cast<double>(unsent_bytes) / 1e3, 0) +
                " kB are waiting. Until it reads again, the newest drive replaces older ones. Is it busy or "
                "stopped?");
    else if (unsent_bytes == 0)
        notices_.over(Topic::Queue, "The server reads commands again.");
}

void Vigil::lookAtOverlong(std::uint64_t count) {
    if (std::exchange(overlong_, count) != count)
        notices_.say(Severity::Warning, Topic::Overlong,
                     "The server sent a line longer than 4 MiB. It was skipped; reading continues after it.");
}

} // namespace usar::mission
