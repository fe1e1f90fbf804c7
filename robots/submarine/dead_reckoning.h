// What the robot knows of its own motion without a sensor for it: an estimate from propeller, planes and rudder.
#pragma once

#include <deque>
#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::submarine {

/// The stock robot has no attitude sensor. But planes turn a moving hull, its weight is below its center of buoyancy
/// and rights it, and the water brakes both; so the plane angles of the last seconds determine the pitch. Planes that
/// lift the nose also push the stern and with it the hull down, so it climbs less steeply than it points. The model is
/// valid under water only; at the surface the hull lies flatter. Errors do not accumulate, because the righting moment
/// removes them.
class PitchModel {
public:
    /// Advances the model by `dt`. The plane angle is that of STA, positive if it lifts the nose; the propeller speed
    /// is a share of the greatest, negative in reverse.
    void step(Seconds dt, double propeller_share, double stern_plane_rad);

    double speed_m_s() const { return speed_m_s_; }   ///< along the hull
    double pitch_rad() const { return pitch_rad_; }   ///< positive nose up
    double climb_m_s() const;                         ///< vertical speed of the hull, positive upward
    double rate_rad_s() const { return rate_rad_s_; } ///< rate of change of the pitch
    /// Returns the plane angle that brings the hull to this pitch quickly and holds it there. It is not limited to what
    /// the planes can do.
    double planeFor_rad(double pitch_rad) const;

private:
    void stepOnce(double dt_s, double thrust_n, double stern_plane_rad);

    double speed_m_s_ = 0.0;
    double heave_m_s_ = 0.0; ///< speed across the hull, positive toward its top
    double pitch_rad_ = 0.0;
    double rate_rad_s_ = 0.0;
};

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
