// Sensors of a robot's own motion: INS, GroundTruth, Odometry, Encoder, Tachometer, Accel, AcceleroMeter, Touch, GPS.
#pragma once

#include "core/sim/sensors/ins.h"
#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// Settings: sigma, precision, drifting (0 or 1); see Ins.
class InsSensor : public Sensor {
public:
    InsSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

private:
    Ins ins_;
    Seconds scan_interval_;
};

/// Reports the true pose of the base.
class GroundTruthSensor : public Sensor {
public:
    GroundTruthSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
    std::vector<protocol::Setting> settings() const override;

private:
    Seconds scan_interval_;
};

/// Dead reckoning from two wheels. Their slip is the only error (robots-and-worlds.md 4.6). Settings: wheel_radius,
/// wheel_separation (m); the words left and right name the joints of the wheels. RESET sets the pose to 0.
class OdometrySensor : public Sensor {
public:
    /// `left` and `right` are the links of the wheels.
    OdometrySensor(const SensorModel& model, const SensorBirth& birth, int left, int right);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

private:
    int left_;
    int right_;
    double radius_m_;
    double separation_m_;
    Seconds scan_interval_;
    double last_left_rad_ = 0.0;
    double last_right_rad_ = 0.0;
    Pose base_in_start_; ///< estimate since the spawn or the last RESET
};

/// A running count of a joint's angle in steps of `resolution` (rad), with each increment off by a share of `sigma`.
/// With a `sign` of -1 it counts down when the wheel rolls forward, as the P2DX's encoders do (protocol.md 4.5).
/// RESET sets it to 0.
class EncoderSensor : public Sensor {
public:
    /// `link` is the one on the joint that it counts.
    EncoderSensor(const SensorModel& model, const SensorBirth& birth, int link);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
    std::vector<protocol::Setting> settings() const override;
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

private:
    int joint_;
    double resolution_rad_;
    double sign_;
    double sigma_;
    Random random_;
    double last_rad_ = 0.0;
    double counted_rad_ = 0.0;
};

/// Reports speeds and angles of the drive's joints, in their order.
class TachometerSensor : public Sensor {
public:
    TachometerSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    std::vector<int> joints_;
    Seconds scan_interval_;
};

/// Accel reports the acceleration without gravity, AcceleroMeter with it: the mean over a tick, in the sensor's frame.
/// Settings: sigma (m/s2).
class AccelerationSensor : public Sensor {
public:
    /// `proper` includes gravity.
    AccelerationSensor(const SensorModel& model, const SensorBirth& birth, bool proper);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    bool proper_;
    double sigma_m_s2_;
    Random random_;
    Seconds scan_interval_;
    std::optional<Vec3> last_velocity_m_s_; ///< at the last measurement; nullopt before it
};

/// Reports whether the link that carries it was touched since the last tick. Settings: diameter (m).
class TouchSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;
};

/// Model (robots-and-worlds.md 4.8): twelve satellites above the horizon, each received if the sky toward it is open.
/// Four give a fix with a noise of 0.83 m, twelve one of 0.25 m.
class GpsSensor : public Sensor {
public:
    GpsSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
    std::vector<protocol::Setting> settings() const override;

private:
    bool noise_;
    Random random_;
    Seconds scan_interval_;
    std::vector<Vec3> satellites_; ///< unit vectors toward them, map frame
};

} // namespace usar::sim
