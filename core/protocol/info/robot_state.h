// STA: the state of the robot this connection speaks for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info/generic.h"

namespace usar::protocol {

enum class VehicleKind { Unknown, Ground, Aerial, Nautic, Legged, StaticPlatform };

struct JointAngle {
    std::string name{};
    double angle_rad = 0.0;
    bool operator==(const JointAngle&) const = default;
};

/// Both dialects and all kinds; what a kind does not have is absent. Steering angles are counter-clockwise positive.
struct RobotState {
    VehicleKind kind = VehicleKind::Unknown; ///< Unknown also for UDK's aerial vehicle, which sends no Type
    std::optional<Seconds> time{};
    std::optional<Seconds> battery_left{}; ///< a countdown; 99999 s from a UDK robot without a battery
    std::optional<double> front_steer_rad{};
    std::optional<double> rear_steer_rad{};
    std::optional<bool> light_on{};
    std::optional<int> light_intensity_pct{};
    std::optional<int> view{};
    std::vector<JointAngle> joints{}; ///< flippers and legs, in the server's order and sign
    /// What no field above holds, in the server's order: unknown keys, a Type that is no kind we know, a key once more.
    std::vector<KeyValue> others{};
    bool operator==(const RobotState&) const = default;
};

} // namespace usar::protocol
