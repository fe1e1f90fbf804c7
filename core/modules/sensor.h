// The newest reading of every sensor, by type and name.
#pragma once

#include <string>

#include "core/modules/sensor_stores.h"

namespace usar::modules {

/// Non-queued sensor module of the thesis (3.3): a new reading replaces the old one of the same type and name; a bare
/// head ("no news") replaces nothing. Pointers live until the next `take`. Not copied.
class SensorModule {
public:
    SensorModule();
    SensorModule(const SensorModule&) = delete;
    SensorModule& operator=(const SensorModule&) = delete;
    ~SensorModule(); // making and clearing forty stores takes the compiler seconds, so it is done in one place

    /// `now` is the protocol clock, used for readings without a time of their own.
    void take(const protocol::InfoLine& line, Seconds now);

    /// Of any sensor in the table, by its message: `newest<protocol::ImuReading>("IMU")`. An empty name means the first
    /// one that spoke.
    template <class Sensor>
    const Stamped<protocol::ReadingOf<Sensor>>* newest(const std::string& name = {}) const {
        return stores_.of<Sensor>().find(name);
    }
    /// All of one message's sensors, in the order in which they first spoke.
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
    /// Sensors of types that no table knows, and damaged lines of known ones.
    const Stamped<protocol::GenericMessage>* generic(const std::string& type, const std::string& name) const;

private:
    SensorStores<Stamped, protocol::SensorTypes> stores_;
    SensorPlaces<Stamped<protocol::GenericMessage>> generic_;
};

} // namespace usar::modules
