// Decides what to do about a threat: the rules of the thesis (4.3, 4.4), plus a memory of obstacles that are not
// visible now.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/threat_zones.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

enum class EvasionMode {
    None,    ///< fly to the goal
    Flee,    ///< high risk: move along `flee_bearing_rad` without turning, suddenly at first
    Divert,  ///< low risk, or one that ended too recently: fly to `diversion_m` first
    Enclosed ///< there is a risk and no way out at this height
};

struct EvasionDecision {
    EvasionMode mode = EvasionMode::None;
    Vec2 diversion_m = Vec2::Zero(); ///< map frame; only for Divert
    double flee_bearing_rad = 0.0;   ///< map frame; only for Flee
    /// It has just begun to flee. A robot that flees for longer has come to speed, and must get to know the wind.
    bool sudden = false;
    bool new_low_risk = false; ///< new in this tick and worth a mark on the map, like the two below
    bool new_high_risk = false;
    bool new_diversion = false;
};

/// Returns the bearing (robot frame) of the free direction next to the greatest threat: the first sonar without a risk
/// on the side with the greater sum of ranges. Returns nullopt if no sonar is free of risk.
std::optional<double> freeBearing(const ThreatPicture& picture);

/// Returns whether a low risk needs no diversion, because the goal is farther to the side than the free direction
/// (around a corner, or a near miss at an outer sonar) or nearer than the obstacle. Bearings are in the robot's frame.
/// There must be a greatest threat.
bool mayIgnore(const ThreatPicture& picture, double free_bearing_rad, double goal_bearing_rad, double goal_distance_m);

/// What is known of the places to which the robot may flee, besides the remembered obstacles. Nothing looks backward,
/// so only where it has flown is it sure that no wall stands.
struct Retreat {
    std::function<bool(const Vec2&)> flown{}; ///< whether it has flown there (map frame); empty: nothing is known
    bool only_there = false;                  ///< walls are likely, so it flees nowhere else; needs `flown`
};

/// Returns the direction of flight away from `threat_bearing_rad`, both in the map frame: straight back or, if
/// remembered obstacles are there, the nearest direction with `needed_m` of free way. Where walls are likely, only
/// directions count in which the robot has flown. Returns nullopt if there is none.
std::optional<double> escapeBearing(std::span<const Obstacle> obstacles, const Vec2& from_m, double threat_bearing_rad,
                                    double needed_m, const Retreat& retreat = {});

/// Keeps a diversion until there has been no risk for `calm_cycles` usual ticks. Call `observe` once per tick and then
/// `decide` at most once. Owned by one robot.
class Evasion {
public:
    /// Judges whether the threat matters on the way to the goal, and whether the last one ended long enough ago to
    /// continue.
    void observe(const Senses& senses, const ThreatPicture& picture, const Vec2& goal_m, const Settings& settings);
    /// Whether there is a high risk, or a low one on the way.
    bool threatMatters() const { return matters_; }
    /// The mode that was decided last; None once there has been no risk for long enough.
    EvasionMode mode() const { return mode_; }

    EvasionDecision decide(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                           const Settings& settings, const Retreat& retreat = {});
    /// Returns the bearing (map frame) away from the greatest threat; nullopt if that is not a high risk or there is no
    /// way out.
    static std::optional<double> escape_rad(const Senses& senses, const ThreatPicture& picture,
                                            std::span<const Obstacle> obstacles, const Retreat& retreat = {});
    void reset() { *this = {}; }

private:
    EvasionDecision flee(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                         const Retreat& retreat);
    EvasionDecision divert(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                           const Settings& settings);
    void calm(Seconds now, const Settings& settings);

    EvasionMode mode_ = EvasionMode::None;
    Vec2 diversion_m_ = Vec2::Zero();
    bool matters_ = false;
    std::optional<Seconds> calm_since_;
    Seconds fled_since_{0.0};
    agent::Risk risk_ = agent::Risk::None;
    agent::Risk last_risk_ = agent::Risk::None; ///< risk at the previous observation
};

} // namespace usar::airrobot
