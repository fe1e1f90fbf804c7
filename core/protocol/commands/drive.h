// DRIVE commands for vehicles. A value remains in force until the next DRIVE; an absent value leaves the old one in
// force.
#pragma once

#include <optional>
#include <vector>

namespace usar::protocol {

/// Switches that may accompany any DRIVE or be sent alone. `flip` rights a robot that has fallen over (UT2004).
/// On the wire: `DRIVE {Light true} {Flip false}`.
struct DriveSwitches {
    std::optional<bool> light_on{};
    std::optional<bool> flip{};
    bool operator==(const DriveSwitches&) const = default;
};

/// DRIVE for skid-steered robots: the wheel spins of both sides. If `normalized` is set, here and below, speeds are in
/// percent of the robot's maximum and are limited to -100..100, except wheel spins of an OmniDrive, which are not
/// limited. A DRIVE without any value has no effect; it reads back as an AerialDrive without any value.
/// On the wire: `DRIVE {Left 1} {Right -1} {Normalized false}`.
struct SkidDrive {
    std::optional<double> left_rad_s{};
    std::optional<double> right_rad_s{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const SkidDrive&) const = default;
};

/// DRIVE for cars. Steering angles are counterclockwise positive, so a positive front angle turns left. UDK obeys only
/// if all three values are there, so absent ones are written as 0 for UDK, unless DriveGate has filled them in with the
/// values sent last.
/// On the wire: `DRIVE {Speed 3} {FrontSteer -0.5} {RearSteer 0} {Normalized false}`.
struct AckermannDrive {
    std::optional<double> speed_rad_s{}; ///< wheel spin
    std::optional<double> front_steer_rad{};
    std::optional<double> rear_steer_rad{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const AckermannDrive&) const = default;
};

/// The values for one of several wheels.
struct WheelDrive {
    int wheel = 0; ///< from 0
    std::optional<double> spin_rad_s{};
    std::optional<double> steer_rad{}; ///< counterclockwise positive
    bool operator==(const WheelDrive&) const = default;
};
/// DRIVE for robots whose wheels are driven and steered one by one; wheels that are not listed keep their values.
/// On the wire: `DRIVE {WheelNumber 0} {WheelSpeed 3} {WheelSteer -0.5} {WheelNumber 1} {WheelSpeed 3}`.
struct OmniDrive {
    std::vector<WheelDrive> wheels{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const OmniDrive&) const = default;
};

/// DRIVE for flying robots.
/// On the wire: `DRIVE {AltitudeVelocity 0.5} {LinearVelocity 1} {LateralVelocity -0.25} {RotationalVelocity 0.1}`.
struct AerialDrive {
    std::optional<double> climb_m_s{}; ///< up positive
    std::optional<double> forward_m_s{};
    std::optional<double> left_m_s{};       ///< left positive; the wire's lateral velocity is right positive
    std::optional<double> yaw_rate_rad_s{}; ///< counterclockwise positive
    bool normalized = false;
    std::optional<double> pitch_rad{}; ///< UDK only; positive lowers the nose
    std::optional<double> roll_rad{};  ///< UDK only
    DriveSwitches switches{};
    bool operator==(const AerialDrive&) const = default;
};

/// DRIVE for boats and submarines. Angles have the server's sign.
/// On the wire: `DRIVE {Propeller 20} {Rudder 0.25} {SternPlane -0.125} {Normalized false}`.
struct NauticDrive {
    std::optional<double> propeller_rad_s{};
    std::optional<double> rudder_rad{};
    std::optional<double> stern_plane_rad{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const NauticDrive&) const = default;
};

} // namespace usar::protocol
