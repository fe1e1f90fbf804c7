// DRIVE commands for vehicles on wheels, and what they share with those in flight.h and joint.h. A value remains in
// force until the next DRIVE; an absent value leaves the old one in force.
#pragma once

#include <optional>
#include <vector>

#include "core/protocol/commands/description.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

inline constexpr CommandWord drive_word{.word = "DRIVE",
                                        .help = "moves the robot or one joint until the next DRIVE",
                                        .example = "DRIVE {Left 1} {Right 1}",
                                        .drives = true};

/// Switches that may accompany any DRIVE or be sent alone. `flip` rights a robot that has fallen over (UT2004).
/// On the wire: `DRIVE {Light true} {Flip false}`.
struct DriveSwitches {
    std::optional<bool> light_on{};
    std::optional<bool> flip{};
    bool operator==(const DriveSwitches&) const = default;

    static constexpr auto& word = drive_word;
    /// A line with one of these keys is a DriveSwitches only if no other kind of DRIVE claims it.
    static constexpr auto weak_signs = texts("Light", "Flip", "");
    static void segments(auto& io, auto& switches) {
        io.flag({"Light", "head lights"}, switches.light_on);
        io.flag({"Flip", "true rights the robot (UT2004)"}, switches.flip);
    }
};

/// DRIVE for skid-steered robots: the wheel spins of both sides. If `normalized` is set, here and below, speeds are in
/// percent of the robot's maximum and are limited to -100..100, except wheel spins of an OmniDrive, which are not
/// limited. A DRIVE without any value has no effect; it reads back as an AerialDrive without any value.
/// On the wire: `DRIVE {Left 1} {Right -1} {Normalized false}`.
struct SkidDrive {
    /// Positive spins drive forward; percent instead of rad/s if `normalized` is set.
    std::optional<double> left_rad_s{};
    std::optional<double> right_rad_s{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const SkidDrive&) const = default;

    static constexpr auto& word = drive_word;
    static constexpr auto signs = texts("Left", "Right");
    static void segments(auto& io, auto& drive) {
        io.beginScale(drive.normalized);
        io.number({"Left", "wheel spin of the left side, rad/s or percent"}, drive.left_rad_s, {.scaled = true});
        io.number({"Right", "wheel spin of the right side, rad/s or percent"}, drive.right_rad_s, {.scaled = true});
        io.endScale();
        DriveSwitches::segments(io, drive.switches);
    }
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

    static constexpr auto& word = drive_word;
    /// One of these keys suffices to recognize the kind of DRIVE.
    static constexpr auto signs = texts("Speed", "FrontSteer", "RearSteer");
    static void segments(auto& io, auto& drive) {
        const bool udk = io.dialect() == Dialect::Udk;
        io.beginScale(drive.normalized);
        io.number({"Speed", "wheel spin of a steered car, rad/s or percent"}, drive.speed_rad_s,
                  {.scaled = true, .or_zero = udk});
        io.number({"FrontSteer", "front steering angle, rad; to the right is positive"}, drive.front_steer_rad,
                  {.turned = true, .or_zero = udk});
        io.number({"RearSteer", "rear steering angle, rad"}, drive.rear_steer_rad, {.turned = true, .or_zero = udk});
        io.endScale();
        DriveSwitches::segments(io, drive.switches);
    }
};

/// The values for one of several wheels.
struct WheelDrive {
    int wheel = 0; ///< from 0
    /// Percent of the maximum if `normalized` of the OmniDrive is set; not limited.
    std::optional<double> spin_rad_s{};
    std::optional<double> steer_rad{}; ///< counterclockwise positive
    bool operator==(const WheelDrive&) const = default;

    static void segments(auto& io, auto& drive) {
        io.number({"WheelNumber", "the wheel that WheelSpeed and WheelSteer mean, from 0"}, drive.wheel);
        io.number({"WheelSpeed", "spin of that wheel, rad/s"}, drive.spin_rad_s);
        io.number({"WheelSteer", "steering angle of that wheel, rad"}, drive.steer_rad, {.turned = true});
    }
};
/// DRIVE for robots whose wheels are driven and steered one by one; wheels that are not listed keep their values.
/// On the wire: `DRIVE {WheelNumber 0} {WheelSpeed 3} {WheelSteer -0.5} {WheelNumber 1} {WheelSpeed 3}`.
struct OmniDrive {
    std::vector<WheelDrive> wheels{};
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const OmniDrive&) const = default;

    static constexpr auto& word = drive_word;
    static constexpr auto signs = texts("WheelNumber");
    static void segments(auto& io, auto& drive) {
        io.groups("WheelNumber", drive.wheels);
        io.beginScale(drive.normalized);
        io.endScale();
        DriveSwitches::segments(io, drive.switches);
    }
};

} // namespace usar::protocol
