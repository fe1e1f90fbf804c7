// Feels that the robot rests on something that no sensor has seen, and frees it.
#pragma once

#include <optional>
#include <vector>

#include "robots/airrobot/flight/pilot.h"
#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// A robot whose belly has come to rest on a wire or on the edge of a rack tips over if it goes on sinking. It feels
/// that it does not sink, or that it tips, and rises. If it tips as it rises, something beside it, such as a rack,
/// holds its ring down, and it sinks a little. Owned by one robot.
class BellyTouch {
public:
    /// The part of the last command that matters here.
    struct Doing {
        double climb_m_s = 0.0;
        double speed_m_s = 0.0;  ///< on the level, over ground
        bool in_wind = false;    ///< A robot that turns there leans as it usually does not.
        bool from_above = false; ///< It sinks away from a roof or a twig: it begins late, and what leans it is above.
        bool to_ground = false;  ///< It lands: low down, it may stand on the ground.
        double leans_more = 0.0; ///< than its commands and its usual lean explain (tangent), see TopTouch
    };
    /// The motion by which it gets free in this tick; nullopt if nothing holds it. `slope` is that of a plane on which
    /// the robot would lean as it usually does now, see Lean. Call it once per tick.
    std::optional<Motion> free(const Senses& senses, const Vec2& slope, const Doing& doing);
    /// Where it has met something in this tick (map frame); nullopt in most ticks.
    const std::optional<Vec3>& met_m() const { return met_m_; }
    bool rises() const { return rises_to_m_.has_value(); } ///< from what it has met

private:
    /// The robot's height, and the height to which its commands would have brought it from an arbitrary start.
    struct Sample {
        Seconds time{0.0};
        double z_m = 0.0;
        double free_m = 0.0;
    };

    void follow(const Senses& senses, const Doing& doing);
    bool rests(const Senses& senses) const;
    static bool tips(const Senses& senses, const Vec2& lean, const Doing& doing);

    std::vector<Sample> samples_; ///< They reach back as far as a touch takes to feel.
    double free_m_s_ = 0.0;       ///< the rate of climb that the commands would have brought about
    std::optional<Vec3> met_m_;
    std::optional<double> rises_to_m_; ///< map z
    Seconds rising_since_{0.0};
    bool level_ = false;                 ///< It has been level since it began to rise.
    std::optional<Seconds> sinks_since_; ///< away from what has held one side of it as it rose
};

} // namespace usar::airrobot
