// Where a robot that sees nothing of the land around it has been: reckoned by its own propeller and rudder.
#pragma once

#include <deque>
#include <optional>

#include "core/base/geometry.h"

namespace usar::submarine {

/// Places where it could follow the bottom, newest last. Metres and radians, in a frame that begins where the robot
/// does. Errors grow with every turn, so only what lies some tens of meters back is worth going back to.
class Trail {
public:
    /// `step_m` along the hull, negative astern; `rudder_share` is 1 hard over to the right.
    void step(double step_m, double rudder_share);
    /// It is well here.
    void keepPlace();
    /// The newest place that is so far from here, or else the oldest; nothing where there is none.
    std::optional<Vec2> placeBehind(double distance_m) const;
    double distanceTo_m(const Vec2& place_m) const { return (place_m - here_m_).norm(); }
    /// From the bow to the place, positive to the left.
    double bearingOf_rad(const Vec2& place_m) const;

private:
    Vec2 here_m_ = Vec2::Zero();
    double yaw_rad_ = 0.0;
    std::deque<Vec2> places_m_;
};

} // namespace usar::submarine
