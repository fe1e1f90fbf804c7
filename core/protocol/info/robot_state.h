// STA: the state of the robot that the connection controls.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info/generic.h"

namespace usar::protocol {

/// The kinds of vehicles by which STA, GEO and CONF classify robots; see vehicle_words.h for the words.
enum class VehicleKind { Unknown, Ground, Aerial, Nautic, Legged, StaticPlatform };

/// The battery time that a UDK robot without a battery reports.
inline constexpr Seconds no_battery{99999.0};

/// One joint and its angle, with the server's sign.
struct JointAngle {
    std::string name{};
    double angle_rad = 0.0;
    bool operator==(const JointAngle&) const = default;
};

/// The state of a robot of any kind, in either dialect; values that a kind does not have are absent. Steering angles
/// are counterclockwise positive.
/// On the wire: `STA {Type AerialVehicle} {Time 268.50} {LightToggle False} {Battery 1180} {View -1}`.
struct RobotState {
    VehicleKind kind = VehicleKind::Unknown; ///< also Unknown for a UDK aerial vehicle, which sends no Type
    std::optional<Seconds> time{};
    std::optional<Seconds> battery_left{}; ///< counts down; `no_battery` without one
    std::optional<double> front_steer_rad{};
    std::optional<double> rear_steer_rad{};
    std::optional<bool> light_on{};
    std::optional<int> light_intensity_pct{};
    std::optional<int> view{};        ///< value of View as sent
    std::vector<JointAngle> joints{}; ///< flippers and legs, in the server's order and sign
    /// Everything that no field above holds, in the server's order: unknown keys, a Type of an unknown kind, repeated
    /// keys.
    std::vector<KeyValue> others{};
    bool operator==(const RobotState&) const = default;
};

} // namespace usar::protocol
