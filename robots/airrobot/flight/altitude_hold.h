// Keeps the height over terrain: high enough over the ground, over peaks nearby and over obstacles ahead.
#pragma once

#include <optional>

#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// Ground lower than this (map z) may be the bed of water, which no sensor sees.
double dryLevel_m(const Settings& settings);

/// Returns the height to hold, as map z. It is the maximum of the mean of the middle rays plus the scan altitude, the
/// highest known object in the footprint or on the way of the next seconds plus the clearance, the floor level, and
/// `at_least_m`. If nothing is within the scanner's reach below, the robot sinks as far as the floor level allows. Over
/// that, and over what may be the bed of water, only its own height keeps it dry, so the floor level is higher there by
/// as much as that height may be wrong.
/// `way_bearing_rad` is the direction of flight in the map frame.
double altitudeGoal_m(const Senses& senses, const ObstacleMemory& memory, double way_bearing_rad, double speed_m_s,
                      std::optional<double> at_least_m, const Settings& settings);

/// Returns the height to hold on the way (map z) instead of `wanted_m`: above the masts nearby, if the robot is above
/// them now. Wires hang between masts, and are too thin for the sensors; robots that sank into one broke.
double aboveWires_m(const Senses& senses, const ObstacleMemory& memory, double wanted_m);

/// Computes the climb rate. Climbing is limited only by the climb speed. Sinking is no steeper than the sonars can see
/// ahead and down (half their beam), unless the scanner has seen the way ahead from another lane, the robot is not
/// moving, or the caller knows the way. So the robot never sinks onto a peak that it has not seen (thesis 4.6). Owned
/// by one robot.
class AltitudeHold {
public:
    /// Returns the climb rate toward the height `goal_m`, positive upward; call it once per tick. `known`: the way
    /// ahead is known to the caller, even if not to the memory.
    double climbRate_m_s(const Senses& senses, const ObstacleMemory& memory, double goal_m, double way_bearing_rad,
                         double speed_m_s, const Settings& settings, bool known = false);

private:
    bool moving_ = false; ///< for hysteresis: small errors are ignored, because every change makes the INS drift
};

} // namespace usar::airrobot
