// DRIVE of vehicles. A value stays in force until the next DRIVE; an absent one keeps what it was.
#pragma once

#include <optional>
#include <vector>

namespace usar::protocol {

/// What may go with any DRIVE, or alone. Flip rights a robot that fell over (UT2004).
struct DriveSwitches {
    std::optional<bool> light_on{};
    std::optional<bool> flip{};
    bool operator==(const DriveSwitches&) const = default;
};

/// Skid-steered robots: wheel spin. `normalized`, here and below: speeds are per cent of the robot's maximum, and what
/// is beyond -100..100 is cut. A DRIVE without any term says nothing; it reads back as an AerialDrive without any.
struct SkidDrive {
    std::optional<double> left_rad_s{};
    std::optional<double> right_rad_s{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const SkidDrive&) const = default;
};

/// Cars. Steering angles are counter-clockwise positive, so that a positive front one turns left. UDK acts only when it
/// has all three: what is absent is written as 0 for it (DriveGate fills in what was said last).
struct AckermannDrive {
    std::optional<double> speed_rad_s{}; ///< wheel spin
    std::optional<double> front_steer_rad{};
    std::optional<double> rear_steer_rad{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const AckermannDrive&) const = default;
};

/// One wheel of many.
struct WheelDrive {
    int wheel = 0; ///< from 0
    std::optional<double> spin_rad_s{};
    std::optional<double> steer_rad{}; ///< counter-clockwise positive
    bool operator==(const WheelDrive&) const = default;
};
struct OmniDrive {
    std::vector<WheelDrive> wheels{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const OmniDrive&) const = default;
};

/// Flying robots.
struct AerialDrive {
    std::optional<double> climb_m_s{}; ///< up positive
    std::optional<double> forward_m_s{};
    std::optional<double> left_m_s{};       ///< left positive; the wire's lateral velocity is right positive
    std::optional<double> yaw_rate_rad_s{}; ///< counter-clockwise positive
    bool normalized = false;
    std::optional<double> pitch_rad{}; ///< UDK only; positive lowers the nose
    std::optional<double> roll_rad{};  ///< UDK only
    DriveSwitches switches{};
    bool operator==(const AerialDrive&) const = default;
};

/// Boats and submarines. Angles have the server's sign.
struct NauticDrive {
    std::optional<double> propeller_rad_s{};
    std::optional<double> rudder_rad{};
    std::optional<double> stern_plane_rad{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const NauticDrive&) const = default;
};

} // namespace usar::protocol
