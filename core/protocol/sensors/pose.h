// SEN messages about the robot's pose: INS, INU, ground truth and odometry.
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The robot's own estimate of its pose, which drifts. It has no Time on the wire in either dialect.
struct InsReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose base_in_map{};

    static constexpr std::string_view wire_types = "INS";
    static constexpr auto items() { return std::tuple(pose(&InsReading::base_in_map, true)); }
    bool operator==(const InsReading&) const = default;
};

/// An older kind of INS that gives the attitude only.
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
struct GroundTruthReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose base_in_map{};

    static constexpr std::string_view wire_types = "GroundTruth";
    static constexpr auto items() { return std::tuple(pose(&GroundTruthReading::base_in_map, true)); }
    bool operator==(const GroundTruthReading&) const = default;
};

/// The pose by dead reckoning in the frame of the spawn pose. Only x, y and yaw are sent; z, roll and pitch are 0.
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

} // namespace usar::protocol
