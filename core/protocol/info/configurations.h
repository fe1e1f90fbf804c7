// Typed configurations with units, made from the settings that a server sent in a CONF. A value that the server did not
// send is absent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/protocol/info/answers.h"

namespace usar::protocol {

/// The configuration of a robot. The server's MaxSpeed is a wheel spin; the limits in m/s and of the yaw rate are those
/// of aerial robots.
struct RobotConfiguration {
    std::string steering{}; ///< SkidSteered, AckermanSteered, OmniDrive, None …
    /// Largest spin of a wheel; percent in a normalized DRIVE refer to it.
    std::optional<double> wheel_speed_limit_rad_s{};
    std::optional<double> front_steer_limit_rad{};
    std::optional<double> rear_steer_limit_rad{};
    /// Aerial robots only, as are the next three.
    std::optional<double> forward_limit_m_s{};
    std::optional<double> sideways_limit_m_s{};
    std::optional<double> climb_limit_m_s{};
    std::optional<double> yaw_rate_limit_rad_s{};
};

/// A joint of a mission package or an actuator; values are in m instead of rad if it is prismatic. `smallest` and
/// `largest` are absent if the server's smallest value exceeds its largest.
struct LinkConfiguration {
    int link = 0;                        ///< from 1; 0 if the server's number is invalid
    std::optional<double> speed_limit{}; ///< rad/s or m/s
    std::optional<double> smallest{};    ///< rad or m
    std::optional<double> largest{};     ///< rad or m
};

/// The configuration of a mission package or an actuator, with its links in the server's order.
struct PackageConfiguration {
    std::string name{};
    std::vector<LinkConfiguration> links{};
};

/// The configuration of a sensor of any type; settings that this type does not have are absent.
struct SensorConfiguration {
    std::string name{};
    std::optional<double> range_max_m{};
    std::optional<double> fov_rad{}; ///< horizontal
};

/// The configuration of a camera. UT2004 sends the angles in radians, UDK in degrees. Only UDK sends the camera's area
/// in the picture, which is how the two are told apart.
struct CameraConfiguration {
    std::string name{};
    std::optional<double> fov_rad{}; ///< current angle; UDK only
    std::optional<double> default_fov_rad{};
    std::optional<double> smallest_fov_rad{};
    std::optional<double> largest_fov_rad{};
    std::optional<int> picture_width_px{}; ///< of its area; UDK only
};

/// The configuration of a robot; nullopt if the message is not about a single robot.
std::optional<RobotConfiguration> robotConfigurationOf(const ConfigurationInfo& info);
/// Configurations of MisPkg and Actuator; empty for messages about anything else, like the functions below.
std::vector<PackageConfiguration> packageConfigurationsOf(const ConfigurationInfo& info);
std::vector<CameraConfiguration> cameraConfigurationsOf(const ConfigurationInfo& info);
/// Configurations of every other type that accepts no opcodes, so that it is no effecter.
std::vector<SensorConfiguration> sensorConfigurationsOf(const ConfigurationInfo& info);

} // namespace usar::protocol
