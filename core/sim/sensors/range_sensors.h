// Sonar, IR, Range, RangeScanner and IRScanner as sensors of a robot.
#pragma once

#include "core/sim/sensors/range_scanner.h"
#include "core/sim/sensors/sensor.h"
#include "core/sim/sensors/sonar.h"

namespace usar::sim {

/// A sonar. Settings: min_range, max_range (m), beam_angle (rad, full), cones, rays_per_cone, sigma.
class SonarSensor : public Sensor {
public:
    SonarSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    Sonar sonar_;
};

/// A single ray: IR, and the single-ray laser Range. Settings: min_range, max_range (m), sigma.
class RaySensor : public Sensor {
public:
    RaySensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    double minimum_m_;
    double maximum_m_;
    RangeNoise noise_;
};

/// A line scanner. Settings: min_range, max_range (m), resolution, fov (rad), sigma, auto (0: measures only on SET …
/// SCAN).
class ScannerSensor : public Sensor {
public:
    ScannerSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

private:
    RangeScanner scanner_;
    bool by_itself_;      ///< measures at each tick, without SCAN
    bool wanted_ = false; ///< a SCAN waits for the next tick
};

} // namespace usar::sim
