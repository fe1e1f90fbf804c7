// SEN messages of inertial sensors: Accel, AcceleroMeter and IMU (all UDK only).
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// Acceleration in the body frame, without gravity.
/// On the wire: `SEN {Time 32} {Type Accel} {Name a} {Acceleration 1,2,3}`.
struct AccelerationReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// In our axes: x forward, y left, z up.
    Vec3 acceleration_m_s2 = Vec3::Zero();

    static constexpr std::string_view wire_types = "Accel";
    static constexpr auto items() {
        return std::tuple(
            item("Acceleration", &AccelerationReading::acceleration_m_s2, "acceleration", "m/s²", Crossing::Vector));
    }
    bool operator==(const AccelerationReading&) const = default;
};

/// Proper acceleration in the body frame, as a real accelerometer measures it: including gravity, so not zero at rest.
/// On the wire: `SEN {Time 32} {Type AcceleroMeter} {Name a} {ProperAcceleration 0,0,-9.8065}`.
struct AccelerometerReading {
    std::optional<Seconds> time{};
    std::string name{};
    Vec3 proper_acceleration_m_s2 = Vec3::Zero();

    static constexpr std::string_view wire_types = "AcceleroMeter";
    static constexpr auto items() {
        return std::tuple(item("ProperAcceleration", &AccelerometerReading::proper_acceleration_m_s2,
                               "proper_acceleration", "m/s²", Crossing::Vector));
    }
    bool operator==(const AccelerometerReading&) const = default;
};

/// Values in the body frame. Angular velocity and acceleration are vectors along the axis of rotation, counterclockwise
/// positive.
/// On the wire: `SEN {Time 1} {Type IMU} {Name I} {XYZAcceleration 1,2,3} {AngularVel 0,0,0.5} {Rotation 0,0,1}`.
struct ImuReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// Each value is absent if the line does not have it.
    std::optional<Vec3> acceleration_m_s2{};
    std::optional<Vec3> angular_velocity_rad_s{};
    std::optional<Vec3> angular_acceleration_rad_s2{};
    /// Attitude of the body, with our signs.
    std::optional<Vec3> roll_pitch_yaw_rad{};

    static constexpr std::string_view wire_types = "IMU";
    static constexpr auto items() {
        return std::tuple(
            item("XYZAcceleration", &ImuReading::acceleration_m_s2, "acceleration", "m/s²", Crossing::Vector),
            item("AngularVel", &ImuReading::angular_velocity_rad_s, "angular_velocity", "rad/s", Crossing::Vector),
            item("AngularAccel", &ImuReading::angular_acceleration_rad_s2, "angular_acceleration", "rad/s²",
                 Crossing::Vector),
            item("Rotation", &ImuReading::roll_pitch_yaw_rad, "orientation", "rad", Crossing::Angles));
    }
    bool operator==(const ImuReading&) const = default;
};

} // namespace usar::protocol
