// The robot as its planners see it: what it perceives and what it can do in a tick. Both the C++ state machine and the
// POSH plan are built on this class (the thesis's Context, 4.3).
#pragma once

#include "core/agent/behavior.h"
#include "robots/airrobot/flight/altitude_hold.h"
#include "robots/airrobot/flight/battery_model.h"
#include "robots/airrobot/flight/climb_over.h"
#include "robots/airrobot/flight/column.h"
#include "robots/airrobot/flight/crash_watch.h"
#include "robots/airrobot/flight/detour.h"
#include "robots/airrobot/flight/drape.h"
#include "robots/airrobot/flight/evasion.h"
#include "robots/airrobot/flight/flight_log.h"
#include "robots/airrobot/flight/landing.h"
#include "robots/airrobot/flight/leg.h"
#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/overhead.h"
#include "robots/airrobot/flight/pilot.h"
#include "robots/airrobot/flight/sense_reader.h"
#include "robots/airrobot/flight/steering.h"
#include "robots/airrobot/flight/stuck_watch.h"
#include "robots/airrobot/flight/touches.h"
#include "robots/airrobot/flight/way_back.h"
#include "robots/airrobot/flight/ways.h"

namespace usar::airrobot {

/// In each tick: `perceive`, in flight `look`, then at most one function that commands. Owned by one behavior.
class Craft {
public:
    /// Updates senses and threats and, if `airborne`, memory and battery; publishes pose, scan, path and threat zones.
    void perceive(const agent::Tick& tick, const SensorLayout& layout, bool airborne, agent::CommandPort& port);
    void hear(const protocol::InfoMessage& message) { link_.hear(message); } ///< Call it with every info line.
    /// Judges the threats on the way of this tick. The functions below use the result.
    void look(const Leg& leg);
    bool threatMatters() const { return evasion_.threatMatters(); } ///< a high risk, or a low one on the way
    /// Whether there is a high risk and a way to escape it.
    bool escapeOpen() const { return Evasion::escape_rad(senses, threats, obstacles_, retreat()).has_value(); }
    bool climbingOver() const { return climb_over_.active(); }
    /// Whether the robot is flying around an obstacle by way of a diversion point.
    bool diversionSet() const { return evasion_.mode() == EvasionMode::Divert; }
    /// Whether something is in the way or was a moment ago.
    bool avoiding() const { return threatMatters() || evasion_.mode() != EvasionMode::None || climbingOver(); }
    /// Whether no way leads to the goal, or there was no progress toward it for longer than the settings allow.
    bool stuck() const {
        return no_way_ || detour_.late(senses.now) || stuck_.withoutProgress() > Seconds(settings.give_up_after_s);
    }
    bool walledOff() const { return no_way_; } ///< what it has seen closes all ways; never where it may climb
    bool mayClimb() const; ///< false below a ceiling that leaves no room, and where a person forbids it
    double passesBelow_m() const { return mayClimb() ? passes_below_m : passes_closer_m; } ///< It crosses lower ones.
    /// The ways to take: where it cannot climb, every aisle counts.
    Width narrowest() const { return ways.isUnder() || !mayClimb() ? Width::Least : Width::Usual; }
    void goUnder(const Vec2& place_m); ///< Sinks there, nearby, and stays so low that it gets through doors.
    void comeUp();                     ///< Ends that; call `rise` then.
    double dry_m() const; ///< map z; lower ground may be the bed of water, so the robot does not land there in need
    double speedToward_m_s(const Vec2& place_m) const; ///< that it makes good against the wind, at most the transit's
    const char* crash() const { return crash_; }       ///< what has become of it, such as "it falls"; nullptr: no crash
    Seconds hindered() const { return stuck_.hindered(); } ///< time spent avoiding since the last progress

    /// Decides about the threats judged by `look` and marks risks on the map. Only the first call in a tick decides.
    const EvasionDecision& decide(agent::CommandPort& port);
    /// Flies one tick of the leg. Never returns Unreachable; check `stuck` instead.
    FlightState perform(Maneuver maneuver, const Leg& leg, agent::CommandPort& port);
    /// Looks, decides and performs in the usual order. Returns Unreachable if the robot should give the goal up.
    FlightState fly(const Leg& leg, agent::CommandPort& port);
    /// Climbs or sinks to this height (map z) there, with looks up; returns true once it is as high as ceilings allow.
    bool rise(double goal_z_m, const Vec2& over_m, agent::CommandPort& port);
    /// Where the last `rise` went straight up, if it was not told to do so there; nothing has been above it there.
    const std::optional<Vec2>& column_m() const { return column_.at_m; }
    /// Sinks onto `place_m` until it touches the ground: high up on its way there unless `in_need`, then only over it.
    Descent descend(const Vec2& place_m, bool in_need, agent::CommandPort& port);
    void hover(const Vec2& place_m, agent::CommandPort& port, const std::string& source); ///< Not counted by `stuck`.
    /// Stops without its senses and leans against the wind; below a roof, it sinks a little. Not counted by `stuck`.
    void brace(agent::CommandPort& port, const std::string& source);
    protocol::AerialDrive still() const { return pilot_.still(senses); } ///< see Pilot::still
    bool retrace() { return way_back_.beginWhole(); }    ///< Has it fly back as it came; false if it has been nowhere.
    void leave(bool airborne, agent::CommandPort& port); ///< Sends the last command: it hovers, or rests.
    void rest(agent::CommandPort& port, const std::string& source); ///< Sends a zero DRIVE. Not counted by `stuck`.
    void forgetPlaces(); ///< Forgets what depends on the old position estimate; call it after an INS reset.
    void startAnew();    ///< Forgets evasion and progress; call it before a goal of another kind and after a failure.

    Settings settings;
    Senses senses;
    ThreatPicture threats;
    ObstacleMemory memory;
    BatteryModel battery;
    FlightLog log;
    bool scanned = false; ///< the map got something in this tick
    Touchdown touchdown;
    Overhead overhead;
    Ways ways;
    Refuge refuge;

private:
    void command(const Motion& motion, agent::CommandPort& port, const std::string& source);
    void stayAbove(const Vec3& met_m);
    bool touchesRoof() const; ///< so near to a ceiling that its ring may touch it
    Motion evade(const EvasionDecision& decision, const Leg& leg, FlightState& state);
    Motion cruise(const Leg& leg, FlightState& state);
    Motion climbOver(const Leg& leg, FlightState& state);
    Retreat retreat() const;       ///< In a room, it flees only to where it has flown: no sensor looks backward.
    void noteGoal(const Leg& leg); ///< Looks for a way to a new goal if there was none to the last one.
    std::vector<Obstacle> trunksNear(const Vec2& at_m) const;
    void mindColumn(const AscentStep& step, Motion& motion);
    bool riseElsewhere(double goal_z_m);
    void findWay(const Leg& leg, bool hindered); ///< Has it climb over what hinders it, take a detour, or go back.
    void findClimb();
    double climbRate(const WayAhead& way);
    bool besideOverhang() const;         ///< A nearby obstacle reaches its height and may be wider above, like a trunk.
    void makeSafe(Motion& motion) const; ///< so slow that the robot can stop before the obstacles on its way
    std::optional<double> heldHeight_m(); ///< the least one after a climb; nullopt: none
    void expectCanopy();                  ///< as high near the place of the first take-off as farther off

    SenseReader reader_;
    LinkWatch link_;
    Evasion evasion_;
    std::optional<EvasionDecision> decision_; ///< decision of this tick
    Steering steering_;
    AltitudeHold altitude_;
    HeightAtlas atlas_;
    ClimbOver climb_over_;
    Ascent ascent_;
    Touches touches_;
    Column column_;
    CrashWatch crash_watch_;
    const char* crash_ = nullptr;
    double commanded_climb_m_s_ = 0.0;
    bool ascending_ = false;   ///< the last command was one of `rise`
    double fastest_m_s_ = 0.0; ///< level speed that the robot is capable of
    StuckWatch stuck_;
    Detour detour_;
    WayBack way_back_;
    bool plans_after_way_back_ = false; ///< a climb over what was in the way, or a detour where it may not climb
    Vec2 detour_aim_m_ = Vec2::Zero();
    std::optional<Vec2> goal_m_; ///< of the last tick; nullopt after startAnew()
    bool has_flown_ = false;
    bool no_way_ = false;        ///< to this goal
    bool no_way_before_ = false; ///< to the last one
    Seconds looked_for_way_{0.0};
    Pilot pilot_;
    std::vector<Obstacle> obstacles_; ///< nearby obstacles that reach the present height
    bool blocked_ = false;            ///< in the last tick, something before the robot stopped it
    bool climb_forbidden_ = false;    ///< the robot must climb a lot but cannot do so safely here
    bool climbs_on_ = false;          ///< since the end of the last climb over something
    std::optional<Vec3> climbed_at_;  ///< place of the last climb, whose height is kept for some distance
    std::optional<Vec3> canopy_at_;   ///< place of the take-off, with the height over the canopy that was seen there
};

} // namespace usar::airrobot
