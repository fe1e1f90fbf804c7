// Wishes in the map frame to DRIVE commands: turns, ramps, holds a place.
#pragma once

#include <optional>
#include <string>

#include "core/agent/command_port.h"
#include "robots/airrobot/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// What one tick wants of the motors.
struct Motion {
    Vec2 velocity_in_map_m_s = Vec2::Zero();
    double climb_m_s = 0.0;
    double yaw_rate_rad_s = 0.0;
    bool sudden = false; ///< no ramp
};

/// Yaw rate that turns the nose to `bearing_rad`.
double turnRate_rad_s(const Senses& senses, double bearing_rad, const Settings& settings);
/// Flight along `bearing_rad` (map frame), slower while the nose points elsewhere: nothing flies where it does not
/// look.
Motion toward(const Senses& senses, double bearing_rad, double speed_m_s, const Settings& settings);
/// Back to a place that is to be held.
Motion holding(const Senses& senses, const Vec2& place_m);

/// Ramps speeds up gently (tilt blinds the sonars) and down firmly; sends a DRIVE only when it differs from the last.
/// Owned by one robot.
class Pilot {
public:
    void fly(const Motion& motion, const Senses& senses, agent::CommandPort& port, const std::string& source,
             const Settings& settings);
    void stop(agent::CommandPort& port, const std::string& source);
    /// The last command's horizontal velocity, in the robot's frame.
    Vec2 commandedInBase_m_s() const;

private:
    /// How long the ramp has had since the last command.
    Seconds rampTime(Seconds now);

    Vec2 commanded_m_s_ = Vec2::Zero();
    std::optional<Seconds> last_at_;
    std::optional<protocol::AerialDrive> last_;
};

} // namespace usar::airrobot
