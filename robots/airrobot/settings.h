// Every constant of the AirRobot's flight as one value, and the parameters that people set it by.
#pragma once

#include <vector>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// SI units. [T] is the thesis (4.1, robots-and-worlds 3.1), [SD] the later client built on it; what has no mark was
/// tuned on tall_test. Copied by value: new parameters take effect at the next tick.
struct Settings {
    double scan_altitude_m = 6.0; ///< [T] over the ground below
    double floor_level_m = -25.0; ///< [T] map z that it never sinks below but to land
    double clearance_m = 2.5;
    double footprint_radius_m = 1.8;
    double maximum_height_m = 19.0; ///< at most the scanner's reach
    double scan_speed_m_s = 1.0;
    double transit_speed_m_s = 1.6;
    double climb_speed_m_s = 1.0;
    double descent_speed_m_s = 0.6;
    double turn_rate_rad_s = radians(34.0);
    double acceleration_m_s2 = 0.8;
    double braking_m_s2 = 1.0;
    double safety_margin_m = 0.9;

    double lane_spacing_m = 9.0;
    double quadrant_limit_m = 150.0; ///< [T]
    double goal_distance_m = 20.0;
    double goal_reached_m = 1.5;
    double lookahead_m = 5.0;
    double most_left_out_pct = 10.0;
    double maximum_scan_tilt_rad = 0.2;
    double maximum_scan_turn_rad_s = 0.3;

    /// [T] gives the zones as a drawing only: long in front, short at the sides. Index = steps of 18 degrees off the
    /// nose: M0, L1 R1 … L4 R4.
    double low_risk_0_m = 4.5;
    double low_risk_1_m = 4.2;
    double low_risk_2_m = 3.4;
    double low_risk_3_m = 2.6;
    double low_risk_4_m = 2.2;
    double high_risk_0_m = 2.2;
    double high_risk_1_m = 2.0;
    double high_risk_2_m = 1.6;
    double high_risk_3_m = 1.3;
    double high_risk_4_m = 1.1;

    double evasion_speed_m_s = 0.8; ///< [SD] 40 % of the maximum
    double diversion_distance_m = 4.0;
    long long calm_cycles = 6; ///< [SD]
    double side_clearance_m = 2.4;
    bool climb_over = true;
    double climb_over_after_s = 3.0;
    double climb_standoff_m = 3.2;
    double give_up_after_s = 90.0;
    double scan_memory_s = 600.0;
    double sonar_memory_s = 20.0;

    double battery_range_m = 1000.0;
    double battery_reserve_pct = 15.0; ///< [T]
    double recharge_time_s = 30.0;
    double robot_battery_reserve_s = 60.0;

    double landing_speed_m_s = 0.3;
    double landing_slow_below_m = 3.0;
    double landing_radius_m = 4.0;
    bool correct_heading = true;
    double rest_time_s = 4.0; ///< [T] "several seconds"
    long long reset_attempts = 5;
    double sensor_timeout_s = 1.5;

    double lowRisk_m(std::size_t ring) const;
    double highRisk_m(std::size_t ring) const;
    bool operator==(const Settings&) const = default;
};

/// What a form shows; defaults are those of `Settings`.
const std::vector<agent::ParameterSpec>& parameterSpecs();
/// `parameters` were made from `parameterSpecs`.
Settings settingsFrom(const agent::ParameterSet& parameters);

} // namespace usar::airrobot
