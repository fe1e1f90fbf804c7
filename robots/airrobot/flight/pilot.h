// Converts wanted motions in the map frame to DRIVE commands: turns, ramps the speed, holds a place.
#pragma once

#include <optional>
#include <string>

#include "core/agent/command_port.h"
#include "robots/airrobot/flight/link_watch.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The wanted motion of one tick.
struct Motion {
    Vec2 velocity_in_map_m_s = Vec2::Zero();
    double climb_m_s = 0.0;      ///< positive upward
    double yaw_rate_rad_s = 0.0; ///< positive to the left
    bool sudden = false;         ///< change the speed without a ramp
    bool to_ground = false;      ///< It lands: its legs may come to stand.
};

/// Returns the yaw rate that turns the nose to `bearing_rad` (map frame).
double turnRate_rad_s(const Senses& senses, double bearing_rad, const Settings& settings);
/// How the robot flies while it turns: hardly at all, or wherever a sonar looks.
enum class Corner { Sharp, Round };
/// Returns a flight along `bearing_rad` (map frame). It is slower, down to zero, while the nose points elsewhere, so
/// that the robot does not fly where it cannot see.
Motion toward(const Senses& senses, double bearing_rad, double speed_m_s, const Settings& settings,
              Corner corner = Corner::Sharp);
/// Returns a motion that holds the place (map frame) and flies back to it if necessary.
Motion holding(const Senses& senses, const Vec2& place_m);

/// What passes from what a robot senses to what it does.
inline constexpr Seconds reaction{0.4};
/// Returns the motion for a link as late as the senses say: so slow that the robot stands soon and does not swing. The
/// motion itself if the link is not late.
Motion calmed(Motion motion, const Senses& senses, const Settings& settings);

/// Increases speeds gently, because tilt blinds the sonars, and decreases them firmly. Steers against the wind, which
/// shows as a difference between the velocity over ground and the commanded one. Sends a DRIVE only if it differs from
/// the last one. Owned by one robot.
class Pilot {
public:
    /// Commands a motion. `source` is named as the cause of the command.
    void fly(const Motion& motion, const Senses& senses, agent::CommandPort& port, const std::string& source,
             const Settings& settings);
    /// Commands zero speed without a ramp.
    void stop(agent::CommandPort& port, const std::string& source);
    /// Commands level rest without a ramp and without a look at the senses, which may be silent: the robot leans
    /// against the wind as far as it knows it, unless the link is late. `climb_m_s` is positive upward.
    void brace(const Senses& senses, double climb_m_s, agent::CommandPort& port, const std::string& source);
    /// The DRIVE that keeps it where it is without its senses: it leans against the wind if it has felt any. On
    /// a late link, what seems to be wind may be its own motion of a moment ago, so it does not lean.
    protocol::AerialDrive still(const Senses& senses) const;
    /// The horizontal velocity over ground that was wanted last, in the robot's frame.
    Vec2 wantedInBase_m_s() const { return wanted_in_base_m_s_; }
    /// The last DRIVE, in the robot's frame.
    LinkWatch::Motion told() const {
        if (!last_)
            return {};
        return {Vec3(last_->forward_m_s.value_or(0.0), last_->left_m_s.value_or(0.0), last_->climb_m_s.value_or(0.0)),
                last_->yaw_rate_rad_s.value_or(0.0)};
    }
    /// True if the robot moves otherwise than commanded by more than it does in calm air.
    bool feelsWind() const;
    /// Returns the velocity (map frame) that the robot believes the wind adds to its own through the air.
    const Vec2& drift_m_s() const { return drift_m_s_; }
    /// Forgets it, because something else has held the robot.
    void forgetDrift() { drift_m_s_ = Vec2::Zero(); }
    /// Never commands a greater level speed.
    void limitSpeed(double fastest_m_s) { fastest_m_s_ = fastest_m_s; }
    /// The speed over ground that it can make good along a bearing (map frame), as far as it knows the wind.
    double fastestAlong_m_s(double bearing_rad) const {
        return fastest_m_s_ + drift_m_s_.dot(Vec2(std::cos(bearing_rad), std::sin(bearing_rad)));
    }

private:
    /// Sends the DRIVE for the commanded velocity, unless it is the last one and that is not long ago.
    void send(const Motion& motion, const Senses& senses, agent::CommandPort& port, const std::string& source);
    /// Returns the time that the ramp may use, which is the time since the last command up to a limit.
    Seconds rampTime(Seconds now);

    /// Learns the wind's share of the velocity over ground.
    void learnDrift(const Senses& senses, double dt_s);

    Vec2 commanded_m_s_ = Vec2::Zero(); ///< wanted over ground, map frame
    Vec2 drift_m_s_ = Vec2::Zero();     ///< what the robot moves too much, map frame
    Vec2 wanted_in_base_m_s_ = Vec2::Zero();
    double fastest_m_s_ = 2.0;
    std::optional<Seconds> last_at_;
    std::optional<protocol::AerialDrive> last_;
    std::optional<Seconds> sent_at_; ///< time of the last DRIVE in flight
};

} // namespace usar::airrobot
