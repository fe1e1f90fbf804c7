// Sonar, IR, Range, RangeScanner and IRScanner as sensors of a robot. Models: robots-and-worlds.md 4.1 and 4.2.
#pragma once

#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// Base of the sensors that measure distances. Settings: min_range, max_range (m), sigma. A range r reads
/// r (1 + N(0, sigma)), clamped to the limits; a miss reads the maximum without noise.
class RangeSensor : public Sensor {
public:
    std::vector<protocol::Setting> settings() const override {
        return {setting("MaxRange", maximum_m_), setting("MinRange", minimum_m_)};
    }

protected:
    /// `usual_maximum_m` and `usual_sigma` hold if the model does not give others.
    RangeSensor(const SensorModel& model, const SensorBirth& birth, double usual_maximum_m, double usual_sigma)
        : Sensor(model, birth)
        , maximum_m_(number("max_range", usual_maximum_m))
        , sigma_(error("sigma", usual_sigma)) {}
    /// The range as the sensor reads it. A `range_m` of at least the maximum is a miss.
    double noisy(double range_m);

    double minimum_m_ = number("min_range", 0.1);
    double maximum_m_;

private:
    double sigma_;
};

/// The nearest thing in a cone of rays around its x axis: a central ray, and cones of rays whose half-angles grow
/// evenly to half the beam. What a ray meets too flatly reflects it away (Rays::nearestEcho). Further settings:
/// beam_angle (rad, full), cones and rays_per_cone: 2 and 16, which gives 33 rays; the reference with 161 rays has 10
/// cones. In UDK the central ray alone works, whatever it meets (robots-and-worlds.md 4.2).
class SonarSensor : public RangeSensor {
public:
    SonarSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;
    /// The nearest range with noise; the maximum on a miss.
    double range_m(const Eigen::Isometry3d& link_in_map, const Rays& rays);
    std::size_t rayCount() const { return directions_in_link_.size(); }

private:
    double beam_rad_ = number("beam_angle", radians(15.0));
    std::vector<Vec3> directions_in_link_;
    std::vector<Vec3> directions_in_map_; ///< those of the last measurement; kept to reuse their memory
};

/// A single ray: IR, and the single-ray laser Range.
class RaySensor : public RangeSensor {
public:
    RaySensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
};

/// A line scanner: a fan of single rays in its xy plane, around its x axis. The beams go from right to left, -fov/2 to
/// fov/2 counter-clockwise; there are floor(fov / resolution) + 1 of them. Further settings: resolution, fov (rad,
/// full) and auto (0: measures only on SET … SCAN).
class ScannerSensor : public RangeSensor {
public:
    ScannerSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;
    /// One scan, without time.
    protocol::RangeScan scan(const Eigen::Isometry3d& link_in_map, const Rays& rays);

private:
    double resolution_rad_ = number("resolution", pi / 180.0);
    double fov_rad_ = number("fov", pi);
    std::vector<Vec3> directions_in_link_;
    std::vector<Vec3> directions_in_map_;         ///< those of the last scan; kept to reuse their memory
    bool by_itself_ = number("auto", 1.0) != 0.0; ///< measures at each tick, without SCAN
    bool wanted_ = false;                         ///< a SCAN waits for the next tick
};

} // namespace usar::sim
