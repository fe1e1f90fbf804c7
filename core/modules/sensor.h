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

    const Stamped<protocol::NamedRange>* sonar(const std::string& name) const;
    const Stamped<protocol::RangeScan>* scan(const std::string& name = {}) const;
    const Stamped<protocol::InsReading>* ins() const;
    const Stamped<protocol::GroundTruthReading>* groundTruth() const;
    const Stamped<protocol::OdometryReading>* odometry() const;
    const Stamped<protocol::EncoderTicks>* encoder(const std::string& name) const;
    /// The newest line of a sensor of unknown type, or the newest damaged line of one of known type.
    const Stamped<protocol::GenericMessage>* generic(const std::string& type, const std::string& name) const;

private:
    SensorStores<Stamped, protocol::SensorTypes> stores_;
};

} // namespace usar::modules
