// Keeps the newest reading of a single sensor.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/modules/sensor_stores.h"
#include "core/protocol/fields.h"

namespace usar::modules {

/// Sensor-specific module of the thesis (3.3): `SpecificSensor<protocol::BallReading> ball("ballHelper")`. An empty
/// name accepts every sensor with this message type. A behavior that needs this module owns one and feeds it in
/// `onInfo`.
template <protocol::SensorMessage Sensor>
class SpecificSensor {
public:
    using Reading = protocol::ReadingOf<Sensor>;

    explicit SpecificSensor(std::string name = {}) : name_(std::move(name)) {}

    /// Returns true if the line had a reading of this sensor. `now`, on the protocol's clock, is used for readings
    /// without a time of their own.
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

    /// The newest reading; nullopt before the first.
    const std::optional<Stamped<Reading>>& newest() const { return newest_; }
    /// Number of readings so far.
    std::uint64_t count() const { return count_; }
    const std::string& name() const { return name_; }

private:
    std::string name_;
    std::optional<Stamped<Reading>> newest_;
    std::uint64_t count_ = 0;
};

} // namespace usar::modules
