#include "robots/airrobot/flight/altitude_hold.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

constexpr double way_half_width_m = 1.5;
constexpr double way_ahead_m = 4.0;
constexpr double way_ahead_s = 4.0;
constexpr double gain_per_s = 0.8;
constexpr double start_moving_m = 0.35;
constexpr double stop_moving_m = 0.1;
/// Slope of the lower edge of a sonar's 15 degree beam.
constexpr double sonar_slope = 0.12;
constexpr double known_enough = 0.85;
/// An object whose top is less than this below the robot, or above it, is beside the robot and not under it. It may be
/// a trunk below its crown, so it is no reason to climb here.
constexpr double beside_m = 0.3;
constexpr double standing_m_s = 0.15;
constexpr double wires_reach_m = 12.0; ///< from a mast; most masts in a street are as near to each other
constexpr double over_wires_m = 1.0;
/// Ground may be so much lower than the start and still be dry; the rest is the drift of the height.
constexpr double slightly_lower_m = 0.5;

} // namespace

double dryLevel_m(const Settings& settings) {
    return settings.floor_level_m - settings.clearance_m - slightly_lower_m;
}

double altitudeGoal_m(const Senses& senses, const ObstacleMemory& memory, double way_bearing_rad, double speed_m_s,
                      std::optional<double> at_least_m, const Settings& settings) {
    const double z_m = senses.base_in_map.position_m.z();
    const Vec2 here_m = senses.position2_m();
    double goal_m = senses.ground_m ? *senses.ground_m + settings.scan_altitude_m : z_m - 1.0;
    const double ahead_m = way_ahead_m + way_ahead_s * speed_m_s;
    if (const auto below_m = memory.highest_m(here_m, settings.footprint_radius_m, z_m - beside_m))
        goal_m = std::max(goal_m, *below_m + settings.clearance_m);
    if (const auto top_m = memory.highestAlong_m(here_m, way_bearing_rad, way_half_width_m, ahead_m))
        goal_m = std::max(goal_m, *top_m + settings.clearance_m);
    const bool maybe_water = !senses.ground_m || *senses.ground_m < dryLevel_m(settings);
    goal_m = std::max(goal_m, settings.floor_level_m + (maybe_water ? senses.height_doubt_m : 0.0));
    return std::max(goal_m, at_least_m.value_or(goal_m));
}

double aboveWires_m(const Senses& senses, const ObstacleMemory& memory, double wanted_m) {
    const auto top_m =
        memory.highestMast_m(senses.position2_m(), wires_reach_m, wanted_m - over_wires_m, senses.position_m().z());
    return top_m ? std::max(wanted_m, *top_m + over_wires_m) : wanted_m;
}

double AltitudeHold::climbRate_m_s(const Senses& senses, const ObstacleMemory& memory, double goal_m,
                                   double way_bearing_rad, double speed_m_s, const Settings& settings, bool known) {
    const double error_m = goal_m - senses.base_in_map.position_m.z();
    moving_ = std::abs(error_m) > (moving_ ? stop_moving_m : start_moving_m);
    if (!moving_)
        return 0.0;
    const double wanted_m_s = gain_per_s * error_m;
    if (wanted_m_s > 0.0)
        return std::min(wanted_m_s, settings.climb_speed_m_s);
    double sink_m_s = settings.descent_speed_m_s;
    known = known ||
            memory.knownAlong(senses.position2_m(), way_bearing_rad, way_half_width_m, way_ahead_m) >= known_enough;
    if (speed_m_s > standing_m_s && !known)
        sink_m_s = std::min(sink_m_s, sonar_slope * speed_m_s);
    return -std::min(-wanted_m_s, sink_m_s);
}

} // namespace usar::airrobot
