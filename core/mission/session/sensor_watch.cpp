#include "core/mission/session/sensor_watch.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/protocol/sensors/silence.h"

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

} // namespace usar::mission
