// A way around what the steering cannot see past.
#pragma once

#include <optional>
#include <vector>

#include "robots/airrobot/flight/route_map.h"

namespace usar::airrobot {

/// Owned by one robot. Places are in the map frame.
class Detour {
public:
    bool active() const { return !way_.empty(); }
    void end() { way_.clear(); }
    /// Whether the way leads through a place that is narrower than usual.
    bool isNarrow() const { return active() && narrow_; }

    /// Looks for a way to `goal_m`; false if there is none.
    bool start(const RouteMap& map, const Senses& senses, const Vec2& goal_m, Width width);
    /// The point to steer at; call it once per tick while active. Ends the detour where the straight way to the goal is
    /// free, and where no way is left. Where the robot gets no farther, the map learns that something is there.
    Vec2 aim_m(RouteMap& map, const Senses& senses);
    /// True if the detour takes far longer than its length allows.
    bool late(Seconds now) const { return active() && now > latest_; }

private:
    void dropPassed(const Vec2& here_m);
    void learnFromStanding(RouteMap& map, const Senses& senses);

    std::vector<Vec2> way_; ///< what is left of it
    Vec2 goal_m_ = Vec2::Zero();
    Width width_ = Width::Usual;
    bool narrow_ = false;
    Seconds planned_{0.0};
    Seconds latest_{0.0};
    Vec2 moved_to_m_ = Vec2::Zero(); ///< where the robot was when it moved last
    Seconds moved_at_{0.0};
};

} // namespace usar::airrobot
