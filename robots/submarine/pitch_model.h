// How the hull lies and where it goes, reckoned from what the robot knows of itself: its propeller and its planes.
#pragma once

#include "core/base/clock.h"

namespace usar::submarine {

/// The stock robot has no sensor of attitude. But planes turn a hull that makes way, its weight hangs below its
/// buoyancy and rights it, and the water brakes both; so the fins of the last seconds tell the pitch. Planes that lift
/// the nose also push the stern down, and the hull with it: it climbs less than it points. Right under water only, at
/// the surface the hull lies flatter; errors do not grow, for the righting moment forgets them.
class PitchModel {
public:
    /// The planes as STA tells them, positive lifts the nose; the propeller as a share of its largest speed, negative
    /// in reverse.
    void step(Seconds dt, double propeller_share, double stern_plane_rad);

    double speed_m_s() const { return speed_m_s_; } ///< along the hull
    double pitch_rad() const { return pitch_rad_; } ///< nose up is positive
    double climb_m_s() const;                       ///< of the hull, whatever the bottom does
    double rate_rad_s() const { return rate_rad_s_; }
    /// The planes that would bring the hull to this pitch and rest there, and hurry it on its way.
    double planeFor_rad(double pitch_rad) const;

private:
    void stepOnce(double dt_s, double thrust_n, double stern_plane_rad);

    double speed_m_s_ = 0.0;
    double heave_m_s_ = 0.0; ///< upward across the hull
    double pitch_rad_ = 0.0;
    double rate_rad_s_ = 0.0;
};

} // namespace usar::submarine
