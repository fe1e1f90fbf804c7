// How the robot of a connection is driven, and how fast it may go, as far as its messages say.
#pragma once

#include <optional>
#include <string>

#include "core/base/stick.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Kind of DRIVE that a robot obeys. `Walker`: the four legs of an ERS, moved by their joints.
enum class DriveStyle { Unknown, Aerial, Skid, Ackermann, Nautic, Walker };

/// Learned from STA (kind, joints), CONF (steering and limits) and GEO (wheels) in both dialects, no matter who asked
/// for them. A value, to be fed with every message of one connection; it has no clock and no thread. Limits are
/// magnitudes; absent ones are not known.
struct DriveLimits {
    protocol::VehicleKind kind = protocol::VehicleKind::Unknown; ///< from its STA
    DriveStyle style = DriveStyle::Unknown;
    std::string hindrance{}; ///< why it cannot be driven by hand although everything is known; a sentence, or empty
    bool configured = false; ///< CONF has arrived, or is not expected any more

    std::optional<double> wheel_speed_rad_s{}; ///< fastest spin of a wheel
    std::optional<double> wheel_radius_m{};
    std::optional<double> wheel_separation_m{};
    std::optional<double> front_steer_rad{};
    std::optional<double> rear_steer_rad{};
    std::optional<double> forward_m_s{}; ///< of an aerial robot, like the next three
    std::optional<double> sideways_m_s{};
    std::optional<double> climb_m_s{};
    std::optional<double> yaw_rate_rad_s{};
    std::optional<double> propeller_rad_s{};
    std::optional<double> rudder_rad{};
    std::optional<double> stern_plane_rad{};

    /// Learns from one message; ignores messages that say nothing about driving.
    void take(const protocol::InfoMessage& message);
    /// To be called when GETCONF gets no answer: a ground vehicle is then assumed to be skid-steered, as most are.
    void giveUpAsking();
    /// True if enough is known to send a DRIVE that does what the user means. A ground vehicle must first report how
    /// it steers.
    bool known() const { return style != DriveStyle::Unknown; }
    /// The axes that the robot can follow; none while its style is unknown.
    StickAxes axes() const;
    /// Speed over ground in m/s at full stick; nullopt if unknown.
    std::optional<double> topSpeed_m_s() const;

    bool operator==(const DriveLimits&) const = default;

private:
    void takeState(const protocol::RobotState& state);
    void takeConfiguration(const protocol::ConfigurationInfo& info);
    void takeGeometry(const protocol::GeometryInfo& info);
};

} // namespace usar::mission
