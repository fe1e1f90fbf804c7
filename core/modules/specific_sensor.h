// One sensor and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/modules/sensor_stores.h"
#include "core/protocol/fields.h"

namespace usar::modules {

/// Sensor-specific module of the thesis (3.3): `SpecificSensor<protocol::BallReading> ball("ballHelper")`. An empty
/// name follows whichever speaks. A behavior that wants it owns one and feeds it in `onInfo`.
template <protocol::SensorMessage Sensor>
class SpecificSensor {
public:
    using Reading = protocol::ReadingOf<Sensor>;

    explicit SpecificSensor(std::string name = {}) : name_(std::move(name)) {}

    /// True when the line told something of this sensor.
    bool take(const protocol::InfoLine& line, Seconds now) {
        const auto* const message = std::get_if<Sensor>(&line.message);
        if (!message)
            return false;
        const std::uint64_t before = count_;
        protocol::forEachReading(*message, [&](const std::string& name, const Reading& reading) {
            if (!name_.empty() && name != name_)
                return;
            newest_ = {reading, protocol::timeOf(line.message).value_or(now), line.number};
            ++count_;
        });
        return count_ != before;
    }

    const std::optional<Stamped<Reading>>& newest() const { return newest_; }
    /// Readings so far.
    std::uint64_t count() const { return count_; }
    const std::string& name() const { return name_; }

private:
    std::string name_;
    std::optional<Stamped<Reading>> newest_;
    std::uint64_t count_ = 0;
};

} // namespace usar::modules
