// Getting over what cannot be flown around: away from it, straight up until the way is free, then across.
#pragma once

#include <optional>
#include <span>

#include "robots/airrobot/obstacle_memory.h"
#include "robots/airrobot/senses.h"
#include "robots/airrobot/settings.h"
#include "robots/airrobot/threat_zones.h"

namespace usar::airrobot {

enum class ClimbState { Inactive, Backing, Climbing, Over, Failed };

struct ClimbStep {
    ClimbState state = ClimbState::Inactive;
    Vec2 place_m = Vec2::Zero(); ///< to go to (Backing) or to stay at (Climbing)
    double climb_m_s = 0.0;
};

/// Crowns are wider above than what the sonars see of them, so a place is sought first that is `climb_standoff_m` from
/// everything known. Owned by one robot; stepped once a tick while active.
class ClimbOver {
public:
    void start(const Senses& senses, std::span<const Obstacle> obstacles, const Settings& settings);
    ClimbStep step(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                   const Vec2& goal_m, const Settings& settings);
    bool active() const { return state_ == ClimbState::Backing || state_ == ClimbState::Climbing; }
    void reset() { *this = {}; }

private:
    bool wayIsFree(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                   const Vec2& goal_m) const;

    ClimbState state_ = ClimbState::Inactive;
    Vec2 place_m_ = Vec2::Zero();
    Seconds since_{0.0};
    std::optional<double> free_since_z_m_;
};

/// Place within 6 m, reachable on this level, whose distance to everything known is best (up to `standoff_m`).
Vec2 climbPlace_m(std::span<const Obstacle> obstacles, const Vec2& here_m, double standoff_m);

} // namespace usar::airrobot
