// The robot as its planners see it: what it perceives, and what it can do in a tick. Both the C++ state machine and a
// POSH plan stand on this (the thesis's Context, 4.3).
#pragma once

#include <string>

#include "core/agent/behavior.h"
#include "robots/airrobot/altitude_hold.h"
#include "robots/airrobot/battery_model.h"
#include "robots/airrobot/climb_over.h"
#include "robots/airrobot/evasion.h"
#include "robots/airrobot/flight_log.h"
#include "robots/airrobot/landing.h"
#include "robots/airrobot/obstacle_memory.h"
#include "robots/airrobot/pilot.h"
#include "robots/airrobot/steering.h"
#include "robots/airrobot/stuck_watch.h"

namespace usar::airrobot {

/// A flight of one tick: the point to reach, the point to steer at on the way, how fast.
struct Leg {
    Vec2 goal_m = Vec2::Zero();
    Vec2 aim_m = Vec2::Zero();
    double speed_m_s = 1.0;
    std::string source; ///< for the cause of the commands
};

enum class FlightState { Flying, Evading, ClimbingOver, Unreachable };

/// What one tick of flight can be.
enum class Maneuver {
    Cruise,   ///< along the leg, over and beside what is known
    Avoid,    ///< away from a high risk, around a low one, or waiting between two
    ClimbOver ///< away from the obstacle, straight up, across
};

/// Owned by one behavior; `perceive` first, then at most one act a tick. In flight, `look` comes between them.
class Craft {
public:
    /// Senses, memory, threats, battery; publishes pose, scan, path and zones.
    void perceive(const agent::Tick& tick, const SensorLayout& layout, bool airborne, agent::CommandPort& port);

    /// Judges the threats on the way of this tick, for what follows.
    void look(const Leg& leg);
    /// There is a high risk, or a low one on the way.
    bool threatMatters() const { return evasion_.threatMatters(); }
    /// There is a high risk, and a way out of it.
    bool escapeOpen() const { return Evasion::escape_rad(senses, threats, obstacles_).has_value(); }
    bool climbingOver() const { return climb_over_.active(); }
    bool diversionSet() const { return evasion_.mode() == EvasionMode::Divert; }
    /// Something is in the way, or was a moment ago.
    bool avoiding() const { return threatMatters() || evasion_.mode() != EvasionMode::None || climbingOver(); }
    /// The goal has not come nearer for as long as the settings allow.
    bool stuck() const { return stuck_.withoutProgress() > Seconds(settings.give_up_after_s); }
    Seconds hindered() const { return stuck_.hindered(); }

    /// What to do about the threats that were looked at: once a tick, with its marks on the map.
    const EvasionDecision& decide(agent::CommandPort& port);
    /// One tick of the leg. Never Unreachable: `stuck` tells.
    FlightState perform(Maneuver maneuver, const Leg& leg, agent::CommandPort& port);
    /// All of it in the usual order: looks, decides, performs; Unreachable when it is time to give the goal up.
    FlightState fly(const Leg& leg, agent::CommandPort& port);
    /// Straight up over the place where it began; true when `goal_z_m` is reached.
    bool rise(double goal_z_m, const Vec2& over_m, agent::CommandPort& port);
    /// Straight down onto `place_m`; true when the ground is touched.
    bool descend(const Vec2& place_m, agent::CommandPort& port);
    /// Waits over a place; the goal's time limit waits too.
    void hover(const Vec2& place_m, agent::CommandPort& port, const std::string& source);
    /// Zero DRIVE; the goal's time limit waits.
    void rest(agent::CommandPort& port, const std::string& source);

    /// After an INS reset: everything that is bound to the old estimate.
    void forgetPlaces();
    /// Before a new goal of another kind (home, a new lane).
    void startAnew();

    Settings settings;
    Senses senses;
    ThreatPicture threats;
    ObstacleMemory memory;
    BatteryModel battery;
    FlightLog log;
    Touchdown touchdown;

private:
    Motion motionFor(Maneuver maneuver, const Leg& leg, FlightState& state, agent::CommandPort& port);
    Motion evade(const EvasionDecision& decision, const Leg& leg, FlightState& state);
    Motion cruise(const Leg& leg, FlightState& state);
    Motion climbOver(const Leg& leg, FlightState& state);
    double climbRate(double way_bearing_rad, double speed_m_s);
    /// Something beside reaches our level and may be wider above: a trunk under its crown.
    bool besideOverhang() const;
    void makeSafe(Motion& motion) const;
    std::optional<double> heldHeight_m();

    SenseReader reader_;
    Evasion evasion_;
    std::optional<EvasionDecision> decision_; ///< of this tick
    Steering steering_;
    AltitudeHold altitude_;
    ClimbOver climb_over_;
    StuckWatch stuck_;
    Pilot pilot_;
    std::vector<Obstacle> obstacles_; ///< that reach the flight level now
    bool climb_forbidden_ = false;    ///< much climb is needed and none is safe here
    std::optional<Vec3> climbed_at_;  ///< height is kept until some way past it
};

} // namespace usar::airrobot
