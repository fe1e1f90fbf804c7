// DRIVE commands for vehicles in the air and in water. What drive.h says about values holds here too.
#pragma once

#include <optional>

#include "core/protocol/commands/drive.h"

namespace usar::protocol {

/// DRIVE for flying robots. UDK expects the yaw rate in degrees per second, but not if speeds are in percent. A
/// Normalized that stands alone is read as one of these, because it is a drive of any kind without values.
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

    static constexpr auto& word = drive_word;
    static constexpr auto signs =
        texts("AltitudeVelocity", "LinearVelocity", "LateralVelocity", "RotationalVelocity", "PitchAngle", "RollAngle");
    /// A lone Normalized is claimed only if no other kind of DRIVE fits.
    static constexpr auto weak_signs = texts("Normalized");
    static void segments(auto& io, auto& drive) {
        io.beginScale(drive.normalized);
        io.number({"AltitudeVelocity", "climb, m/s; up is positive"}, drive.climb_m_s, {.scaled = true});
        io.number({"LinearVelocity", "forward, m/s"}, drive.forward_m_s, {.scaled = true});
        io.number({"LateralVelocity", "sideways, m/s; right is positive"}, drive.left_m_s,
                  {.turned = true, .scaled = true});
        const bool degrees = io.dialect() == Dialect::Udk && !drive.normalized;
        io.number({"RotationalVelocity", "turn, rad/s (UDK: degrees/s); clockwise is positive"}, drive.yaw_rate_rad_s,
                  {.turned = true, .scaled = true, .degrees = degrees});
        io.endScale();
        io.number({"PitchAngle", "pitch in degrees (UDK)"}, drive.pitch_rad, {.turned = true, .degrees = true});
        io.number({"RollAngle", "roll in degrees (UDK)"}, drive.roll_rad, {.degrees = true});
        DriveSwitches::segments(io, drive.switches);
    }
};

/// DRIVE for boats and submarines. Angles have the server's sign.
/// On the wire: `DRIVE {Propeller 20} {Rudder 0.25} {SternPlane -0.125} {Normalized false}`.
struct NauticDrive {
    /// Percent of the maximum if `normalized` is set.
    std::optional<double> propeller_rad_s{};
    /// The embedded simulator takes angles for percent, too, if `normalized` is set.
    std::optional<double> rudder_rad{};
    std::optional<double> stern_plane_rad{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const NauticDrive&) const = default;

    static constexpr auto& word = drive_word;
    static constexpr auto signs = texts("Propeller", "Rudder", "SternPlane");
    static void segments(auto& io, auto& drive) {
        io.beginScale(drive.normalized);
        io.number({"Propeller", "propeller speed, or percent"}, drive.propeller_rad_s, {.scaled = true});
        io.number({"Rudder", "rudder angle, rad"}, drive.rudder_rad);
        io.number({"SternPlane", "stern plane angle, rad"}, drive.stern_plane_rad);
        io.endScale();
        DriveSwitches::segments(io, drive.switches);
    }
};

} // namespace usar::protocol
