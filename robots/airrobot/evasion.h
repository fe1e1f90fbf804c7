// What to do about a threat: the rules of the thesis (4.3, 4.4), with a memory of what cannot be seen now.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry.h"
#include "robots/airrobot/obstacle_memory.h"
#include "robots/airrobot/settings.h"
#include "robots/airrobot/threat_zones.h"

namespace usar::airrobot {

enum class EvasionMode {
    None,    ///< fly to the goal
    Flee,    ///< high risk: sudden movement along `flee_bearing_rad`, facing as before
    Divert,  ///< low risk, or calm for too short a time: fly to `diversion_m` first
    Enclosed ///< at risk and no way out on this level
};

struct EvasionDecision {
    EvasionMode mode = EvasionMode::None;
    Vec2 diversion_m = Vec2::Zero();
    double flee_bearing_rad = 0.0; ///< map frame
    bool new_low_risk = false;     ///< worth a mark on the map
    bool new_high_risk = false;
    bool new_diversion = false;
};

/// Free segment next to the greatest threat: the side whose sonars sum up to more; the first risk-free sonar on it.
/// Bearing in the robot's frame; nothing when no sonar is free of risk.
std::optional<double> freeBearing(const ThreatPicture& picture);

/// A low risk that needs no diversion: the goal lies farther out than the free direction (cornering, a near miss at an
/// edge sonar) or nearer than the obstacle.
bool mayIgnore(const ThreatPicture& picture, double free_bearing_rad, double goal_bearing_rad, double goal_distance_m);

/// Direction of flight, in the map frame, away from `threat_bearing_rad`: straight back if memory allows it, else the
/// nearest direction to it with `needed_m` of free way; nothing if there is none.
std::optional<double> escapeBearing(std::span<const Obstacle> obstacles, const Vec2& from_m, double threat_bearing_rad,
                                    double needed_m);

/// Keeps the mode until a time of `calm_cycles` usual ticks was without a risk. Owned by one robot; once a tick it
/// observes, then may decide.
class Evasion {
public:
    /// Judges the tick's picture: whether the threat matters on the way to the goal, and whether it has been calm for
    /// long enough to go on.
    void observe(const Senses& senses, const ThreatPicture& picture, const Vec2& goal_m, const Settings& settings);
    /// There is a high risk, or a low one on the way.
    bool threatMatters() const { return matters_; }
    /// What was decided last, until the calm has lasted.
    EvasionMode mode() const { return mode_; }

    EvasionDecision decide(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                           const Settings& settings);
    /// Map bearing away from the greatest threat that is a high risk; nothing without one, or without a way.
    static std::optional<double> escape_rad(const Senses& senses, const ThreatPicture& picture,
                                            std::span<const Obstacle> obstacles);
    void reset() { *this = {}; }

private:
    EvasionDecision flee(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles);
    EvasionDecision divert(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                           const Settings& settings);
    EvasionDecision keep() const;
    void calm(Seconds now, const Settings& settings);

    EvasionMode mode_ = EvasionMode::None;
    Vec2 diversion_m_ = Vec2::Zero();
    bool matters_ = false;
    std::optional<Seconds> calm_since_;
    agent::Risk risk_ = agent::Risk::None;
    agent::Risk last_risk_ = agent::Risk::None; ///< at the observation before
};

} // namespace usar::airrobot
