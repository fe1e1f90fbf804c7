// Keeps the newest reading of every sensor, by type and name.
#pragma once

#include <string>

#include "core/modules/sensor_stores.h"

namespace usar::modules {

/// Non-queued sensor module of the thesis (3.3): a new reading replaces the old one of the same type and name; a line
/// without data replaces nothing. Returned pointers are valid until the next `take` and are nullptr if the sensor has
/// not reported yet.
class SensorModule {
public:
    SensorModule();
    SensorModule(const SensorModule&) = delete;
    SensorModule& operator=(const SensorModule&) = delete;
    ~SensorModule(); // out of line: the code for forty stores takes the compiler seconds

    /// `now` is the time on the protocol's clock, used for readings without a time of their own.
    void take(const protocol::InfoLine& line, Seconds now);

    /// The newest reading of any sensor in the table, by its message type: `newest<protocol::ImuReading>("IMU")`. An
    /// empty name, here and below, means the sensor that reported first.
    template <class Sensor>
    const Stamped<protocol::ReadingOf<Sensor>>* newest(const std::string& name = {}) const {
        return stores_.of<Sensor>().find(name);
    }
    /// All sensors with this message type, in the order in which they first reported.
    template <class Sensor>
    const auto& all() const {
        return stores_.of<Sensor>().all();
    }

    auto* sonar(const std::string& name) const { return newest<protocol::SonarReadings>(name); }
    auto* scan(const std::string& name = {}) const { return newest<protocol::RangeScan>(name); }
    auto* ins() const { return newest<protocol::InsReading>(); }
    auto* groundTruth() const { return newest<protocol::GroundTruthReading>(); }
    auto* odometry() const { return newest<protocol::OdometryReading>(); }
    auto* encoder(const std::string& name) const { return newest<protocol::EncoderReadings>(name); }
    /// The newest line of a sensor of unknown type, or the newest damaged line of one of known type.
    auto* generic(const std::string& type, const std::string& name) const {
        return stores_.of<protocol::GenericMessage>().find(name, type);
    }

private:
    SensorStores<Stamped, protocol::SensorTypes> stores_;
};

} // namespace usar::modules
