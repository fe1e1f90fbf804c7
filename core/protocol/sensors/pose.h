// SEN messages about the robot's pose: INS, INU, ground truth and odometry, and with a single figure about it,
// AltitudeSensor and MagneticCompass (both UDK only).
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The robot's own estimate of its pose, which drifts. It has no Time on the wire in either dialect.
/// On the wire: `SEN {Type INS} {Name INS} {Location 4.50,1.90,1.80} {Orientation 0.00,6.28,3.01}`.
struct InsReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose base_in_map{};

    static constexpr std::string_view wire_types = "INS";
    static constexpr auto items() { return std::tuple(pose(&InsReading::base_in_map, true)); }
    bool operator==(const InsReading&) const = default;
};

/// An older kind of INS that gives the attitude only.
/// On the wire: `SEN {Type INU} {Name I} {Orientation 0.00,0.25,1.50}`.
struct InuReading {
    std::optional<Seconds> time{};
    std::string name{};
    Vec3 roll_pitch_yaw_rad = Vec3::Zero(); ///< attitude of the base in the map frame

    static constexpr std::string_view wire_types = "INU";
    static constexpr auto items() {
        return std::tuple(item("Orientation", &InuReading::roll_pitch_yaw_rad, "orientation", "rad", Crossing::Angles,
                               Decimals::TwoRounded));
    }
    bool operator==(const InuReading&) const = default;
};

/// The exact pose of the robot.
/// On the wire: `SEN {Time 395.3833} {Type GroundTruth} {Name GT} {Location 4.50,1.90,-1.85} {Orientation 0,0.25,6}`.
struct GroundTruthReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose base_in_map{};

    static constexpr std::string_view wire_types = "GroundTruth";
    static constexpr auto items() { return std::tuple(pose(&GroundTruthReading::base_in_map, true)); }
    bool operator==(const GroundTruthReading&) const = default;
};

/// The pose by dead reckoning in the frame of the spawn pose. Only x, y and yaw are sent; z, roll and pitch are 0.
/// On the wire: `SEN {Type Odometry} {Name Odometry} {Pose 0.0320,0.0014,0.0296}`.
struct OdometryReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<Pose> base_in_start{};

    static constexpr std::string_view wire_types = "Odometry";
    static constexpr auto items() {
        return std::tuple(item("Pose", &OdometryReading::base_in_start, "", "", Crossing::Planar));
    }
    bool operator==(const OdometryReading&) const = default;
};

/// Altitudes; up is positive, on the wire as in our frame.
/// On the wire: `SEN {Time 32.1} {Type AltitudeSensor} {Name a} {relativeAltitude 1.25} {absoluteAltitude 141.25}`.
struct AltitudeReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<double> above_start_m{}; ///< the server's relative altitude
    std::optional<double> above_sea_m{};   ///< the server's absolute altitude

    static constexpr std::string_view wire_types = "AltitudeSensor";
    static constexpr auto items() {
        return std::tuple(item("relativeAltitude", &AltitudeReading::above_start_m, "above_start", "m"),
                          item("absoluteAltitude", &AltitudeReading::above_sea_m, "above_sea", "m"));
    }
    bool operator==(const AltitudeReading&) const = default;
};

/// The heading as sent, without a unit: the server truncates the angle to an int and converts it twice
/// (protocol.md 4.5).
/// On the wire: `SEN {Time 1} {Type MagneticCompass} {Name c} {MagneticAngle 2}`.
struct CompassReading {
    std::optional<Seconds> time{};
    std::string name{};
    double raw_angle = 0.0;

    static constexpr std::string_view wire_types = "MagneticCompass";
    static constexpr auto items() { return std::tuple(item("MagneticAngle", &CompassReading::raw_angle, "raw_angle")); }
    bool operator==(const CompassReading&) const = default;
};

} // namespace usar::protocol
