// Sensors that find things and people: RFID, VictSensor, HumanMotion, Sound, CO2Sensor, and the ball finder Helper.
#pragma once

#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// Finds tags within `max_range` (2 m), even behind walls. Reports when the list has changed and is not empty
/// (protocol.md 9.1). SET Read and Write reach the tags on the last list.
class RfidSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
    std::vector<protocol::Setting> settings() const override { return {setting("MaxRange", range_m_)}; }
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

private:
    /// The tag with this id if it is on the last list; otherwise nullptr.
    RfidTag* heard(const std::string& id) const;

    double range_m_ = number("max_range", 2.0);
    Scene* scene_ = nullptr; ///< the scene at the last tick; null before it
    std::vector<int> ids_;
    bool spoken_ = false;
};

/// Finds parts of victims within `max_range` (6 m) and the fields of view (60 and 45 degrees) that nothing hides, at
/// positions with noise of `sigma` (0.02 m). Occasionally, with the probability `false_alarm` (0.01 per measurement),
/// it reports a part that does not exist.
class VictimSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override {
        return {setting("MaxRange", range_m_), setting("HorizontalFOV", horizontal_rad_),
                setting("VerticalFOV", vertical_rad_)};
    }

private:
    double range_m_ = number("max_range", 6.0);
    double horizontal_rad_ = number("horizontal_fov", radians(60.0));
    double vertical_rad_ = number("vertical_fov", radians(45.0));
    double sigma_m_ = error("sigma", 0.02);
    double false_alarm_ = error("false_alarm", 0.01);
};

/// A pyroelectric sensor. The closer a person is within `max_range` (6 m) and `fov` (60 degrees), the higher the
/// reported probability, 0 to 1. Persons whose status is Unconscious or Dead do not move and are not found.
class HumanMotionSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override {
        return {setting("MaxRange", range_m_), setting("Fov", fov_rad_)};
    }

private:
    double range_m_ = number("max_range", 6.0);
    double fov_rad_ = number("fov", radians(60.0));
    double sigma_ = error("sigma", 0.05);
};

/// Reports the loudest source, 6 dB less for each doubling of the distance from 1 m on; nothing below `threshold` (20
/// dB).
class SoundSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override { return {setting("Threshold", threshold_db_)}; }

private:
    double threshold_db_ = number("threshold", 20.0);
    double sigma_db_ = error("sigma", 0.5);
};

/// Reports the sum of all sources of its gas (word `gas`, default CO2), each falling with the square of the distance
/// from 1 m on.
class GasSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override { return {}; }
};

/// The ball finder of the ERS (thesis 5.2): finds the nearest object whose class or name ends with Ball, if nothing
/// hides it within `fov` (56.9 degrees) and `max_range` (10 m). Its position is in the wire's axes (forward, right,
/// down), with noise of `sigma` (0.01) times the distance.
class BallSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override {
        return {setting("MaxRange", range_m_), setting("Fov", fov_rad_)};
    }

private:
    double fov_rad_ = number("fov", radians(56.9));
    double range_m_ = number("max_range", 10.0);
    double sigma_ = error("sigma", 0.01);
};

} // namespace usar::sim
