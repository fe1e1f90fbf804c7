// DRIVE commands for vehicles. A value remains in force until the next DRIVE; an absent value leaves the old one in
// force.
#pragma once

#include <optional>
#include <vector>

namespace usar::protocol {

/// Switches that may accompany any DRIVE or be sent alone. `flip` rights a robot that has fallen over (UT2004).
struct DriveSwitches {
    std::optional<bool> light_on{};
    std::optional<bool> flip{};
    bool operator==(const DriveSwitches&) const = default;
};

/// DRIVE for skid-steered robots: the wheel spins of both sides. If `normalized` is set, here and below, speeds are in
/// percent of the robot's maximum and are limited to -100..100, except wheel spins of an OmniDrive, which are not
/// limited. A DRIVE without any value has no effect; it reads back as an AerialDrive without any value.
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
struct OmniDrive {
    std::vector<WheelDrive> wheels{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const OmniDrive&) const = default;
};

/// DRIVE for flying robots.
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
struct NauticDrive {
    std::optional<double> propeller_rad_s{};
    std::optional<double> rudder_rad{};
    std::optional<double> stern_plane_rad{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const NauticDrive&) const = default;
};

} // namespace usar::protocol
