#include "core/mission/sensor_watch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/protocol/segments.h"

namespace usar::mission {

namespace {

/// Types that are silent while there is nothing to tell (usarsim-protocol 5), and those that a table knows: a line of
/// these that stayed generic is a damaged one.
constexpr std::array<std::string_view, 15> not_watched{
    "RFID",         "RFIDTag", "VictRFID",    "VictSensor", "HumanMotion", "Sound",    "Helper",      "Sonar",
    "RangeScanner", "INS",     "GroundTruth", "Odometry",   "Encoder",     "Acoustic", "ObjectSensor"};

/// The first lines of a tick may come before the first that tells the server's time, which may be hours.
constexpr Seconds clock_unknown{0.0};

/// Calls `speak(type, name)` for each sensor that the message is a reading of.
template <class Speak>
struct Speakers {
    const Speak& speak;

    void operator()(const protocol::SonarReadings& message) const {
        for (const protocol::NamedRange& sonar : message.ranges)
            if (!std::isnan(sonar.range_m))
                speak("Sonar", sonar.name);
    }
    void operator()(const protocol::RangeScan& message) const { speak(message.type, message.name); }
    void operator()(const protocol::InsReading&) const { speak("INS", {}); }
    void operator()(const protocol::GroundTruthReading&) const { speak("GroundTruth", {}); }
    void operator()(const protocol::OdometryReading&) const { speak("Odometry", {}); }
    void operator()(const protocol::EncoderReadings& message) const {
        for (const protocol::EncoderTicks& encoder : message.encoders)
            speak("Encoder", encoder.name);
    }
    void operator()(const protocol::GenericMessage& message) const {
        const auto isType = [&](std::string_view type) { return protocol::sameWord(message.type, type); };
        if (protocol::sameWord(message.type_word, "SEN") && !message.type.empty() &&
            std::ranges::none_of(not_watched, isType))
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
