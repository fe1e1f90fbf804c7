// What a CONF says of one kind of thing, with units: small structures made from the settings that the server sent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

/// Of a robot. The server's MaxSpeed is wheel spin. Limits of speed are an aerial robot's.
struct RobotConfiguration {
    std::string robot_class{};
    VehicleKind kind = VehicleKind::Unknown;
    std::string steering{}; ///< SkidSteered, AckermanSteered, OmniDrive, None …
    std::optional<double> mass_kg{};
    std::optional<double> wheel_speed_limit_rad_s{};
    std::optional<double> torque_limit_n_m{};
    std::optional<double> front_steer_limit_rad{};
    std::optional<double> rear_steer_limit_rad{};
    std::optional<double> forward_limit_m_s{};
    std::optional<double> sideways_limit_m_s{};
    std::optional<double> climb_limit_m_s{};
    std::optional<double> yaw_rate_limit_rad_s{};
    bool operator==(const RobotConfiguration&) const = default;
};

/// A joint of a mission package or an actuator; m instead of rad where it is prismatic. No limits at all where the
/// server's smallest is above its largest.
struct LinkConfiguration {
    int link = 0;
    bool prismatic = false;
    std::optional<double> speed_limit{};  ///< rad/s or m/s
    std::optional<double> torque_limit{}; ///< N m or N
    std::optional<double> smallest{};     ///< rad or m
    std::optional<double> largest{};
    bool operator==(const LinkConfiguration&) const = default;
};

struct PackageConfiguration {
    std::string name{};
    std::vector<LinkConfiguration> links{};
    bool operator==(const PackageConfiguration&) const = default;
};

/// Of a sensor of any type; what the type has not is absent.
struct SensorConfiguration {
    std::string type{};
    std::string name{};
    std::optional<double> range_max_m{};
    std::optional<double> range_min_m{};
    std::optional<double> beam_angle_rad{};
    std::optional<double> resolution_rad{}; ///< of beams, or of an encoder's tick
    std::optional<double> fov_rad{};        ///< horizontal
    std::optional<double> vertical_fov_rad{};
    std::optional<Seconds> scan_interval{};
    std::optional<bool> pans{};
    std::optional<bool> tilts{};
    bool operator==(const SensorConfiguration&) const = default;
};

/// UT2004 gives a camera's angles in radians, UDK in degrees, and only UDK its place in the picture; that is how the
/// two are told apart.
struct CameraConfiguration {
    std::string name{};
    std::optional<double> fov_rad{}; ///< now; UDK only
    std::optional<double> default_fov_rad{};
    std::optional<double> smallest_fov_rad{};
    std::optional<double> largest_fov_rad{};
    std::optional<int> picture_x_px{};
    std::optional<int> picture_y_px{};
    std::optional<int> picture_width_px{};
    std::optional<int> picture_height_px{};
    bool operator==(const CameraConfiguration&) const = default;
};

/// What an effecter can be told, with the range of the value where it takes one.
struct EffecterOpcode {
    std::string opcode{};
    std::optional<double> smallest{};
    std::optional<double> largest{};
    bool operator==(const EffecterOpcode&) const = default;
};

struct EffecterConfiguration {
    std::string type{};
    std::string name{};
    std::vector<EffecterOpcode> opcodes{};
    bool operator==(const EffecterConfiguration&) const = default;
};

/// Nothing where the message is about something else.
std::optional<RobotConfiguration> robotConfigurationOf(const ConfigurationInfo& info);
/// Of MisPkg and Actuator; empty for everything else. The same holds below.
std::vector<PackageConfiguration> packageConfigurationsOf(const ConfigurationInfo& info);
std::vector<CameraConfiguration> cameraConfigurationsOf(const ConfigurationInfo& info);
std::vector<EffecterConfiguration> effecterConfigurationsOf(const ConfigurationInfo& info);
/// Of every type that is none of the others.
std::vector<SensorConfiguration> sensorConfigurationsOf(const ConfigurationInfo& info);

} // namespace usar::protocol
