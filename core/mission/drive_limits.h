// What a connection has taught about how its robot is driven, and how fast it may go.
#pragma once

#include <optional>
#include <string>

#include "core/base/stick.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Which DRIVE it obeys. `Walker`: the four legs of an ERS, by their joints.
enum class DriveStyle { Unknown, Aerial, Skid, Ackermann, Nautic, Walker };

/// Learnt from STA (the kind, the joints), CONF (steering and limits) and GEO (wheels), whoever asked for them, in both
/// dialects. A value, fed with every message of one connection; no clock, no thread. What is absent was not told.
struct DriveLimits {
    protocol::VehicleKind kind = protocol::VehicleKind::Unknown; ///< by its STA
    DriveStyle style = DriveStyle::Unknown;
    std::string hindrance{}; ///< why it cannot be driven by hand although all is known; a sentence, or empty
    bool configured = false; ///< CONF has come

    std::optional<double> wheel_speed_rad_s{}; ///< most spin of a wheel
    std::optional<double> wheel_radius_m{};
    std::optional<double> wheel_separation_m{};
    std::optional<double> front_steer_rad{};
    std::optional<double> rear_steer_rad{};
    std::optional<double> forward_m_s{}; ///< of an aerial robot, as the next three
    std::optional<double> sideways_m_s{};
    std::optional<double> climb_m_s{};
    std::optional<double> yaw_rate_rad_s{};
    std::optional<double> propeller_rad_s{};
    std::optional<double> rudder_rad{};
    std::optional<double> stern_plane_rad{};

    void take(const protocol::InfoMessage& message);
    /// No answer to GETCONF is coming: a ground vehicle is taken for a skid-steered one, as most are.
    void giveUpAsking();
    /// Enough to send a DRIVE that means what the person means. A ground vehicle has to say how it steers first.
    bool known() const { return style != DriveStyle::Unknown; }
    StickAxes axes() const;
    /// At the whole stick, where it is known: m/s over ground.
    std::optional<double> topSpeed_m_s() const;

    bool operator==(const DriveLimits&) const = default;

private:
    void takeState(const protocol::RobotState& state);
    void takeConfiguration(const protocol::ConfigurationInfo& info);
    void takeGeometry(const protocol::GeometryInfo& info);
};

} // namespace usar::mission
