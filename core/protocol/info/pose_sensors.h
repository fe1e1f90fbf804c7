// SEN of the pose family: INS, ground truth, odometry, encoders.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::protocol {

/// SEN INS: the robot's own drifting estimate; no Time on the wire in either dialect.
struct InsReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose base_in_map{};
    bool operator==(const InsReading&) const = default;
};

/// SEN GroundTruth: exact.
struct GroundTruthReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose base_in_map{};
    bool operator==(const GroundTruthReading&) const = default;
};

/// SEN Odometry: dead reckoning in the frame of the spawn pose. Absent values: the server sent a bare head.
struct OdometryReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<Pose> base_in_start{};
    bool operator==(const OdometryReading&) const = default;
};

struct EncoderTicks {
    std::string name{};
    long long ticks = 0; ///< taken as it is: the P2DX counts down when it rolls forward
    bool operator==(const EncoderTicks&) const = default;
};

/// SEN Encoder: all encoders of a tick (UT2004) or one of them (UDK).
struct EncoderReadings {
    std::optional<Seconds> time{};
    std::vector<EncoderTicks> encoders{};
    bool operator==(const EncoderReadings&) const = default;
};

} // namespace usar::protocol
