// Typed configurations with units, made from the settings that a server sent in a CONF. A value that the server did not
// send is absent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

/// The configuration of a robot. The server's MaxSpeed is a wheel spin; the limits in m/s and of the yaw rate are those
/// of aerial robots.
struct RobotConfiguration {
    std::string robot_class{};
    VehicleKind kind = VehicleKind::Unknown;
    std::string steering{}; ///< SkidSteered, AckermanSteered, OmniDrive, None …
    std::optional<double> mass_kg{};
    /// Largest spin of a wheel; percent in a normalized DRIVE refer to it.
    std::optional<double> wheel_speed_limit_rad_s{};
    std::optional<double> torque_limit_n_m{};
    std::optional<double> front_steer_limit_rad{};
    std::optional<double> rear_steer_limit_rad{};
    /// Aerial robots only, as are the next three.
    std::optional<double> forward_limit_m_s{};
    std::optional<double> sideways_limit_m_s{};
    std::optional<double> climb_limit_m_s{};
    std::optional<double> yaw_rate_limit_rad_s{};
    bool operator==(const RobotConfiguration&) const = default;
};

/// A joint of a mission package or an actuator; values are in m instead of rad if it is prismatic. `smallest` and
/// `largest` are absent if the server's smallest value exceeds its largest.
struct LinkConfiguration {
    int link = 0; ///< from 1; 0 if the server's number is invalid
    bool prismatic = false;
    std::optional<double> speed_limit{};  ///< rad/s or m/s
    std::optional<double> torque_limit{}; ///< N m or N
    std::optional<double> smallest{};     ///< rad or m
    std::optional<double> largest{};      ///< rad or m
    bool operator==(const LinkConfiguration&) const = default;
};

/// The configuration of a mission package or an actuator, with its links in the server's order.
struct PackageConfiguration {
    std::string name{};
    std::vector<LinkConfiguration> links{};
    bool operator==(const PackageConfiguration&) const = default;
};

/// The configuration of a sensor of any type; settings that this type does not have are absent.
struct SensorConfiguration {
    std::string type{};
    std::string name{};
    std::optional<double> range_max_m{};
    std::optional<double> range_min_m{};
    /// Opening angle of one beam, such as a sonar's cone.
    std::optional<double> beam_angle_rad{};
    std::optional<double> resolution_rad{}; ///< angle between beams, or of one encoder tick
    std::optional<double> fov_rad{};        ///< horizontal
    std::optional<double> vertical_fov_rad{};
    std::optional<Seconds> scan_interval{};
    std::optional<bool> pans{};
    std::optional<bool> tilts{};
    bool operator==(const SensorConfiguration&) const = default;
};

/// The configuration of a camera. UT2004 sends the angles in radians, UDK in degrees. Only UDK sends the camera's area
/// in the picture, which is how the two are told apart.
struct CameraConfiguration {
    std::string name{};
    std::optional<double> fov_rad{}; ///< current angle; UDK only
    std::optional<double> default_fov_rad{};
    std::optional<double> smallest_fov_rad{};
    std::optional<double> largest_fov_rad{};
    std::optional<int> picture_x_px{}; ///< left edge of its area; this and the next three are UDK only
    std::optional<int> picture_y_px{};
    std::optional<int> picture_width_px{};
    std::optional<int> picture_height_px{};
    bool operator==(const CameraConfiguration&) const = default;
};

/// A command that an effecter accepts, with the range of its value if it takes one.
struct EffecterOpcode {
    std::string opcode{};
    std::optional<double> smallest{};
    std::optional<double> largest{};
    bool operator==(const EffecterOpcode&) const = default;
};

/// The configuration of an effecter: all commands that it accepts.
struct EffecterConfiguration {
    std::string type{};
    std::string name{};
    std::vector<EffecterOpcode> opcodes{};
    bool operator==(const EffecterConfiguration&) const = default;
};

/// The configuration of a robot; nullopt if the message is not about a single robot.
std::optional<RobotConfiguration> robotConfigurationOf(const ConfigurationInfo& info);
/// Configurations of MisPkg and Actuator; empty for messages about anything else, like the functions below.
std::vector<PackageConfiguration> packageConfigurationsOf(const ConfigurationInfo& info);
std::vector<CameraConfiguration> cameraConfigurationsOf(const ConfigurationInfo& info);
std::vector<EffecterConfiguration> effecterConfigurationsOf(const ConfigurationInfo& info);
/// Configurations of every type that none of the functions above covers.
std::vector<SensorConfiguration> sensorConfigurationsOf(const ConfigurationInfo& info);

} // namespace usar::protocol
