// Height over terrain: high enough over the ground below, over tips around and over what lies ahead.
#pragma once

#include <optional>

#include "robots/airrobot/obstacle_memory.h"
#include "robots/airrobot/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The height to hold, map z: the highest of (mean of the middle rays + scan altitude), (highest thing below in the
/// footprint, or along the way of the next seconds + clearance), the floor level, and `at_least_m`. With nothing in the
/// scanner's reach below: sink, as far as the floor allows.
double altitudeGoal_m(const Senses& senses, const ObstacleMemory& memory, double way_bearing_rad, double speed_m_s,
                      std::optional<double> at_least_m, const Settings& settings);

/// Climb rate toward `goal_m`, up positive. Climbs as it must. Sinks no steeper than the sonars can look ahead and
/// down (half their beam), unless the scanner has seen the way ahead from another lane, or the robot stands still: so
/// it never sinks onto a tip that nobody saw (thesis 4.6).
class AltitudeHold {
public:
    double climbRate_m_s(const Senses& senses, const ObstacleMemory& memory, double goal_m, double way_bearing_rad,
                         double speed_m_s, const Settings& settings);

private:
    bool moving_ = false; ///< hysteresis: small errors are left alone, for every change makes the INS drift
};

} // namespace usar::airrobot
