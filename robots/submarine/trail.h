// Dead reckoning for a robot that cannot see its surroundings, from its propeller and rudder.
#pragma once

#include <deque>
#include <optional>

#include "core/base/geometry.h"

namespace usar::submarine {

/// Remembers places where the robot could follow the bottom. Meters and radians, in a frame with its origin at the
/// robot's start and x along its bow there. Errors grow with every turn, so only places up to some tens of meters back
/// are useful.
class Trail {
public:
    /// Moves by `step_m` along the hull, negative backward. `rudder_share` is 1 for hard right and -1 for hard left.
    void step(double step_m, double rudder_share);
    /// Remembers the current place, unless the last one is near.
    void keepPlace();
    /// Returns the newest place that is farther than this from here, otherwise the oldest place; nullopt if there are
    /// no places.
    std::optional<Vec2> placeBehind(double distance_m) const;
    double distanceTo_m(const Vec2& place_m) const { return (place_m - here_m_).norm(); }
    /// The angle from the bow to the place, positive to the left.
    double bearingOf_rad(const Vec2& place_m) const;

private:
    Vec2 here_m_ = Vec2::Zero();
    double yaw_rad_ = 0.0;
    std::deque<Vec2> places_m_; ///< oldest first
};

} // namespace usar::submarine
