// What finds things and people: RFID, VictSensor, HumanMotion, Sound, CO2Sensor, and the ball finder Helper.
#pragma once

#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// Tags within `max_range` (2 m), walls or not. Speaks when the list changes (usarsim-protocol 9.1); SET Read and Write
/// reach what it hears.
class RfidSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
    std::vector<protocol::Setting> settings() const override;
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

private:
    RfidTag* heard(const std::string& id) const;

    Scene* scene_ = nullptr; ///< of the last tick
    std::vector<int> ids_;
    bool spoken_ = false;
};

/// Parts of victims within `max_range` (6 m) and the fields of view (60 and 45 degrees) that nothing hides; each place
/// off by `sigma` (0.02 m). Now and then, with the probability `false_alarm` (0.01 a look), a part that is not there.
class VictimSensor : public Sensor {
public:
    VictimSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    double range_m_;
    double horizontal_rad_;
    double vertical_rad_;
    double sigma_m_;
    double false_alarm_;
    Random random_;
};

/// A pyroelectric eye: the nearer a living person within `max_range` (6 m) and `fov` (60 degrees), the surer. Those
/// whose status is Unconscious or Dead do not move.
class HumanMotionSensor : public Sensor {
public:
    HumanMotionSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    double range_m_;
    double fov_rad_;
    double sigma_;
    Random random_;
};

/// The loudest source, 6 dB less for each doubling of the distance; silent below `threshold` (20 dB).
class SoundSensor : public Sensor {
public:
    SoundSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    double threshold_db_;
    double sigma_db_;
    Random random_;
};

/// The sum of all sources of its gas (word `gas`, CO2), each falling with the square of the distance from 1 m on.
class GasSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override { return {}; }
};

/// The ball finder of the ERS (thesis 5.2): the nearest thing whose class or name ends with Ball, where nothing hides
/// it within `fov` (56.9 degrees) and `max_range` (10 m). Its place is in the wire's axes: forward, right, down; off by
/// `sigma` (0.01, share of the distance).
class BallSensor : public Sensor {
public:
    BallSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    double fov_rad_;
    double range_m_;
    double sigma_;
    Random random_;
};

} // namespace usar::sim
