// Everything a client can ask, as one variant of small structs in our frame and in SI units.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/base/geometry.h"

namespace usar::protocol {

/// INIT: spawn a robot. A start name is not attested for UT2004 servers; send the pose it stands for there.
struct Init {
    std::string class_name{};                ///< "USARBot.AirRobot"
    std::string robot_name{};                ///< any token without space or brace; empty lets the server choose
    std::variant<Pose, std::string> start{}; ///< a pose in the map frame, or the name of a start pose
    std::optional<Pose> fallback_in_map{};   ///< where to spawn when no start pose has that name
    bool operator==(const Init&) const = default;
};

struct GetStartPoses {
    bool operator==(const GetStartPoses&) const = default;
};

/// DRIVE of an aerial robot. Absent terms keep their last value on the server. A value stays in force until replaced.
struct AerialDrive {
    std::optional<double> climb_m_s{}; ///< up positive
    std::optional<double> forward_m_s{};
    std::optional<double> left_m_s{};       ///< left positive; the wire's lateral velocity is right positive
    std::optional<double> yaw_rate_rad_s{}; ///< counter-clockwise positive
    bool normalized = false;                ///< then all terms are per cent of the robot's maximum, -100..100
    bool operator==(const AerialDrive&) const = default;
};

/// DRIVE of a skid-steered robot: wheel spin. An absent side keeps its last value on the server.
struct SkidDrive {
    std::optional<double> left_rad_s{};
    std::optional<double> right_rad_s{};
    bool normalized = false;
    bool operator==(const SkidDrive&) const = default;
};

/// GETGEO and GETCONF: `type` is "Robot" or a sensor type; without a name all items of the type are meant.
struct GetGeometry {
    std::string type{};
    std::string name{};
    bool operator==(const GetGeometry&) const = default;
};
struct GetConfiguration {
    std::string type{};
    std::string name{};
    bool operator==(const GetConfiguration&) const = default;
};

/// SET INS POSE: sets the estimate; only a robot at rest obeys.
struct SetInsPose {
    std::string sensor_name = "INS";
    Pose base_in_map{};
    bool operator==(const SetInsPose&) const = default;
};

/// Our own server's words (README, "Faster than real time"); a real server ignores them in silence.
struct Lockstep {
    bool on = true;
    bool operator==(const Lockstep&) const = default;
};
struct Step {
    bool operator==(const Step&) const = default;
};

/// Any other line, sent as it is and kept whole by a server that does not know it.
struct RawCommand {
    std::string line{};
    bool operator==(const RawCommand&) const = default;
};

using Command = std::variant<RawCommand, Init, GetStartPoses, AerialDrive, SkidDrive, GetGeometry, GetConfiguration,
                             SetInsPose, Lockstep, Step>;

} // namespace usar::protocol
