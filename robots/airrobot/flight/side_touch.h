// Feels that something beside the robot holds its ring, such as a twig or a rack behind it, which no sensor sees, and
// frees it.
#pragma once

#include <deque>
#include <optional>

#include "robots/airrobot/flight/pilot.h"
#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// The direction of the nearest thing that a sonar hears within this distance (map frame), the mean of all sonars that
/// hear it; nullopt if none does.
std::optional<Vec2> towardHeard(const Senses& senses, double within_m);

/// If the ring of a flying robot meets something, that holds it on one side, and the robot turns although it is not
/// told to, or a sonar there hears it at no distance. If the robot goes on pressing, it is turned over. Owned by one
/// robot.
class SideTouch {
public:
    /// The part of the last command that matters here.
    struct Doing {
        double yaw_rate_rad_s = 0.0;
        Vec2 velocity_in_map_m_s = Vec2::Zero();
        double climb_m_s = 0.0;
        bool to_ground = false; ///< It lands: it sinks only over its place.
        /// Something just below it would hold it if it sank.
        bool over_things = false;
    };
    /// The motion by which it gets free in this tick; nullopt if nothing holds it. It sinks a little, because a side
    /// that is held while the robot rises is pressed down, and that turns it over. Call it once per tick.
    std::optional<Motion> free(const Senses& senses, const Doing& doing);
    /// Where it has met something in this tick (map frame); nullopt in most ticks.
    const std::optional<Vec3>& met_m() const { return met_m_; }
    /// True if what it has met in this tick holds it fast: it does not move at all. That looks like wind from ahead.
    bool holdsFast() const { return met_m_ && holds_fast_; }

private:
    struct Told {
        Seconds time{0.0};
        Doing doing;
    };
    /// How much faster the robot turns than any command of the last moments explains; positive to the left.
    double unexplained_rad_s(const Senses& senses) const;
    /// How it was told to fly a moment before it began to turn, or since then; zero if it was to stand.
    Vec2 flewBefore_m_s(Seconds turn) const;
    /// The direction of what holds it (map frame) if it begins to do so in this tick.
    std::optional<Vec2> feel(const Senses& senses);
    /// True if it is told to fly and has not moved at all for a while.
    bool isHeldFast(const Senses& senses, const Vec2& told_m_s);

    std::deque<Told> told_; ///< as far back as a turn takes to begin and to end
    std::optional<Seconds> turning_since_;
    double turns_ = 0.0; ///< the sign of that turn
    std::optional<Vec3> met_m_;
    std::optional<Seconds> still_since_; ///< It is told to fly since then, and is
    Vec2 still_at_m_ = Vec2::Zero();     ///< still there.
    Seconds asked_at_{0.0};
    bool holds_fast_ = false;
    std::optional<Seconds> freeing_since_;
    Motion away_;
};

} // namespace usar::airrobot
