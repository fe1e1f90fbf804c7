// Sensors of a robot's own motion: INS, GroundTruth, Odometry, Encoder, Tachometer, Accel, AcceleroMeter, Touch, GPS.
#pragma once

#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// The inertial navigation sensor: a pose estimate that drifts with the distance traveled (model: robots-and-worlds.md
/// 4.4). It adds the true increments of each scan: angles times 1 + N(bias, sigma), positions plus the step's length
/// times N(bias, sigma), independently for x, y and z. It reports the spawn pose until two scans in a row have seen no
/// rotation. Settings: sigma (0.05), the relative standard deviation of each increment; precision (1000), which bounds
/// the biases: position +-0.5 / precision, rotation +-0.5 / precision^2; drifting (1; 0: both biases are 0). The pose
/// is that of the base; in UDK it is that of the sensor itself, if that is on the chassis (protocol.md 4.5).
class InsSensor : public Sensor {
public:
    InsSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    /// Obeys SetInsPose for this sensor; the response says whether the robot was at rest.
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;
    /// The estimate after one more scan, given the true pose.
    const Pose& estimate(const Pose& base_in_map);
    /// Sets the estimate and zeroes the biases. Returns false, and does nothing, unless the robot is at rest.
    bool setEstimate(const Pose& base_in_map, bool at_rest);

private:
    /// Adds the increment since the last scan, with its errors, to the estimate.
    void integrate(const Pose& base_in_map);
    /// Returns the pose that is reported when the base is at this one.
    Pose reported(const Pose& base_in_map) const;

    double sigma_ = error("sigma", 0.05);
    bool reports_itself_;      ///< instead of the base
    Pose estimate_;            ///< in the map frame; begins at the spawn pose
    std::optional<Pose> last_; ///< the true pose at the last scan; nullopt before it
    /// Relative error of each increment, without a unit; so is `rotation_bias_`.
    Vec3 position_bias_ = Vec3::Zero();
    Vec3 rotation_bias_ = Vec3::Zero();
    int still_scans_ = 0;  ///< scans in a row without rotation
    bool started_ = false; ///< two scans without rotation have been seen
};

/// Reports the true pose of the base.
class GroundTruthSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
};

/// Dead reckoning from two wheels. Their slip is the only error (robots-and-worlds.md 4.6). Settings: wheel_radius,
/// wheel_separation (m); the words left and right name the joints of the wheels. RESET sets the pose to 0.
class OdometrySensor : public Sensor {
public:
    OdometrySensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    std::vector<protocol::Setting> settings() const override;

private:
    bool reset() override {
        base_in_start_ = {};
        return true;
    }

    int left_; ///< the links of the wheels
    int right_;
    double radius_m_ = number("wheel_radius", 0.1);
    double separation_m_ = number("wheel_separation", 0.33);
    /// Angles of the wheels at the last measurement.
    double last_left_rad_ = 0.0;
    double last_right_rad_ = 0.0;
    Pose base_in_start_; ///< estimate since the spawn or the last RESET
};

/// A running count of a joint's angle in steps of `resolution` (rad), with each increment off by a share of `sigma`.
/// With a `sign` of -1 it counts down when the wheel rolls forward, as the P2DX's encoders do (protocol.md 4.5). The
/// word joint names the joint. RESET sets the count to 0.
class EncoderSensor : public Sensor {
public:
    EncoderSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }
    std::vector<protocol::Setting> settings() const override { return {setting("Resolution", resolution_rad_)}; }

private:
    bool reset() override {
        counted_rad_ = 0.0;
        return true;
    }

    int link_; ///< the link on the joint that it counts
    double resolution_rad_ = number("resolution", radians(1.0));
    double sign_ = number("sign", 1.0) < 0.0 ? -1.0 : 1.0;
    double sigma_ = error("sigma", 0.0025);
    double last_rad_ = 0.0;
    double counted_rad_ = 0.0; ///< sum of the increments, before it is cut to whole steps
};

/// Reports speeds and angles of the drive's joints: of a skid drive left, right, left, right from the front
/// (protocol.md 4.5), of other drives in their order.
class TachometerSensor : public Sensor {
public:
    TachometerSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;

private:
    std::vector<int> links_; ///< on the joints
};

/// Accel reports the acceleration without gravity, AcceleroMeter with it: the mean since the last measurement, in the
/// sensor's frame. Settings: sigma (m/s2).
class AccelerationSensor : public Sensor {
public:
    /// `proper` includes gravity.
    AccelerationSensor(const SensorModel& model, const SensorBirth& birth, bool proper)
        : Sensor(model, birth)
        , proper_(proper) {}
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;

private:
    bool proper_;
    double sigma_m_s2_ = error("sigma", 0.02);
    std::optional<Vec3> last_velocity_m_s_; ///< at the last measurement; nullopt before it
    Seconds last_at_{0.0};
};

/// Reports whether the link that carries it was touched since its last report. Settings: diameter (m).
class TouchSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    void passOver(const SensorView& view) override { touched_ |= view.body.touched(model().link); }
    std::vector<protocol::Setting> settings() const override { return {setting("Diameter", number("diameter", 0.01))}; }

private:
    bool touched_ = false; ///< at a tick that was passed over
};

/// Model (robots-and-worlds.md 4.8): twelve satellites above the horizon, each received if the sky toward it is open.
/// Four give a fix with a noise of 0.83 m, twelve one of 0.25 m.
class GpsSensor : public Sensor {
public:
    GpsSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) override;
    bool needsHistory() const override { return false; }

private:
    std::vector<Vec3> satellites_; ///< unit vectors toward them, map frame
};

} // namespace usar::sim
