// Feels that the ring of a robot that climbs has met something from below, such as a twig or a wire, which no sensor
// sees.
#pragma once

#include <optional>

#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// What a ring meets presses it down on that side, and the robot no longer climbs as it is told. One that goes on
/// climbing is turned over. Owned by one robot; make a new one for each climb.
class RingTouch {
public:
    static constexpr double least_climb_m_s = 0.15; ///< A slower climb feels nothing.

    /// Returns where the ring has met something (map frame) if it feels that in this tick. `slope` is that of a plane
    /// on which the robot would lean as it usually does now, see Lean. Call it once per tick.
    std::optional<Vec3> feel(const Senses& senses, const Vec2& slope, double commanded_m_s);
    /// True if it returned that because a sonar hears something close by, which has not touched the ring yet.
    bool onlyHears() const { return only_hears_; }

private:
    std::optional<Seconds> climbing_since_;
    Vec2 lean_before_ = Vec2::Zero(); ///< in the last tick of this climb
    bool only_hears_ = false;
};

/// How the robot leans, without its usual lean (`slope`, see Lean); it points to the side that is low, map frame.
Vec2 unusualLean(const Senses& senses, const Vec2& slope);

} // namespace usar::airrobot
