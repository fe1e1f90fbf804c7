// Feels that something above, such as a wire, holds down one side of a robot that climbs as it flies on, and frees it.
#pragma once

#include <deque>
#include <optional>

#include "robots/airrobot/flight/pilot.h"
#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// If the ring of a robot that climbs on its way meets something from below, that presses one side down, and within
/// half a second the robot is turned over. It feels that it leans as no command explains, stops and sinks a little.
/// RingTouch feels the same in a climb that goes straight up. Owned by one robot.
class TopTouch {
public:
    /// The part of the last command that matters here.
    struct Doing {
        Vec2 velocity_in_map_m_s = Vec2::Zero(); ///< over ground
        double climb_m_s = 0.0;
    };
    /// The motion by which it gets free in this tick; nullopt if nothing holds it. Call it once per tick.
    std::optional<Motion> free(const Senses& senses, const Doing& doing);
    /// Where it has met something in this tick (map frame); nullopt in most ticks.
    const std::optional<Vec3>& met_m() const { return met_m_; }
    /// By how much more it leans in this tick than its commands and its usual lean explain (tangent); 0 if it does not
    /// know.
    double leansMore() const { return leans_more_; }

private:
    struct Sample {
        Seconds time{0.0};
        Vec2 told_m_s = Vec2::Zero();
        Vec2 lean = Vec2::Zero(); ///< that this command does not explain
    };
    /// How much more than usual it leans in this tick, toward the side that is low (map frame); nullopt if it does not
    /// know.
    std::optional<Vec2> surplus(const Senses& senses, const Doing& doing);

    std::deque<Sample> last_;     ///< oldest first
    double last_climb_m_s_ = 0.0; ///< commanded
    double leans_more_ = 0.0;
    std::optional<Vec3> met_m_;
    std::optional<Seconds> sinking_since_;
};

} // namespace usar::airrobot
