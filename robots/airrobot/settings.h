// The settings of the AirRobot's flight, and the parameters through which the user sets them.
#pragma once

#include <algorithm>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// All values are in SI units. [T] marks values from the thesis (4.1, robots-and-worlds.md 3.1) and [SD] those from the
/// later client built on it; the others were tuned in the world tall_test. Copied by value: new parameters take effect
/// at the next tick.
struct Settings {
    /// As a floor level: the robot chooses it (SurveyFlight::putFloor).
    static constexpr double chosen_floor_m = -500.0;

    /// As a lane spacing or a scan speed: it follows from what the map shall show.
    static constexpr double by_resolution = 0.0;

    // Flight. Heights without another word are over the ground; speeds are limited to what the robot can do.
    double scan_altitude_m = 6.0; ///< [T] over the ground below; 0 in the parameters: by the resolution (see asAsked)
    /// Map z below which the robot never sinks, except to land. [T] has such a level, for water and ravines.
    double floor_level_m = chosen_floor_m;
    double clearance_m = 2.5;        ///< height over the highest known object below and ahead
    double footprint_radius_m = 1.8; ///< radius within which objects count as below the robot
    double maximum_height_m = 19.0;  ///< greatest height over ground; at most the scanner's reach
    /// Speed along the lanes; 0 in the parameters: as the resolution asks (see asAsked).
    double scan_speed_m_s = 1.0;
    /// Speed to the area, between lanes and on the way home.
    double transit_speed_m_s = 1.6;
    /// Greatest vertical speeds in flight; straight up, where it has not come down before, the robot climbs at 0.7 m/s
    /// at most. Landing has a speed of its own.
    double climb_speed_m_s = 1.0;
    double descent_speed_m_s = 0.6;
    /// Greatest yaw rate. Quick turns make the INS drift more.
    double turn_rate_rad_s = radians(34.0);
    /// The rate at which a commanded horizontal speed grows.
    double acceleration_m_s2 = 0.8;
    double braking_m_s2 = 1.0;    ///< deceleration with which safe speeds are computed
    double safety_margin_m = 0.9; ///< distance from the robot's center to an obstacle at which it must stand

    // Survey. Spacing and quadrants take effect when the lanes are planned, the others at once; so do resolution and
    // overlap for the spacing.
    /// Greatest distance between points on level ground, along the lanes and across them.
    double ground_resolution_m = 0.5;
    /// The next lane's strip shows this share of a strip's width, too.
    double overlap_pct = 25.0;
    /// 0 in the parameters: as resolution and overlap ask (see asAsked).
    double lane_spacing_m = 9.0;
    double quadrant_limit_m = 150.0; ///< [T] an area with a longer side is divided into quadrants
    double goal_distance_m = 20.0;   ///< greatest distance between goals on a lane
    double goal_reached_m = 1.5;     ///< distance at which a goal is reached
    double lookahead_m = 5.0;        ///< distance ahead on the lane at which the robot aims
    /// New area that an extra lane must show per length of lane and of the way to it.
    double least_gain_m = 0.6;
    double most_left_out_pct = 10.0; ///< share of the lanes that may be given up in a successful survey
    /// Scans taken at a greater tilt or during a faster turn are not added to the map.
    double maximum_scan_tilt_rad = 0.2;
    double maximum_scan_turn_rad_s = 0.3;

    /// Ranges below which an echo is a risk. [T] shows the zones only as a drawing: long in front, short at the sides.
    /// The index is the direction of the sonar in steps of 18 degrees from the nose: M0, L1 R1 … L4 R4.
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

    // Evasion. Times are those of the protocol clock. Without progress means that the robot has come less than a meter
    // nearer to its goal (see StuckWatch).
    double evasion_speed_m_s = 0.8; ///< [SD] 40 % of the maximum speed
    /// Distance from the robot to a diversion point.
    double diversion_distance_m = 4.0;
    long long calm_cycles = 6;     ///< [SD] time without a risk before the robot continues, in usual ticks
    double side_clearance_m = 2.4; ///< half the width of the free way that a diversion needs
    /// False: the robot never climbs over obstacles.
    bool climb_over = true;
    /// Time without progress after which the robot climbs.
    double climb_over_after_s = 0.5;
    double climb_standoff_m = 3.2; ///< wanted distance to all obstacles during a climb
    double give_up_after_s = 90.0; ///< time without progress after which a goal is given up
    /// How long the robot avoids what its belly scanner saw and what its sonars heard.
    double scan_memory_s = 600.0;
    double sonar_memory_s = 20.0;

    // Batteries: the simulated one of the thesis is a distance, the robot's own one a time.
    double battery_range_m = 1000.0;       ///< distance that the simulated battery lasts
    double battery_reserve_pct = 15.0;     ///< [T]
    double recharge_time_s = 30.0;         ///< time on the ground for a charge
    double robot_battery_reserve_s = 60.0; ///< reserve of the robot's own battery, beyond the way home

    // Landing, and what the robot does on the ground.
    double landing_speed_m_s = 0.3;
    double landing_slow_below_m = 3.0; ///< height over ground
    double landing_radius_m = 4.0;     ///< distance from the base within which to look for an even place
    bool correct_heading = true;       ///< use the CourseFilter
    /// Take the pose from ground truth instead of the INS, as the thesis did for its longest test (4.6).
    bool navigate_by_truth = false;
    double rest_time_s = 4.0; ///< [T] "several seconds"
    /// Attempts to set the INS before the robot flies on without setting it.
    long long reset_attempts = 5;
    double sensor_timeout_s = 1.5; ///< the robot hovers if a sensor is silent for longer than this

    /// The risk ranges by ring (see ringOf), which must be 0 to 4.
    double lowRisk_m(std::size_t ring) const;
    double highRisk_m(std::size_t ring) const;

    /// Up to this speed, the robot stops early enough among trees. One that is to fly faster takes more care there, and
    /// looks farther ahead.
    static constexpr double unhurried_m_s = 1.6;
    bool hurried() const { return std::max(scan_speed_m_s, transit_speed_m_s) > unhurried_m_s; }

    /// Returns these settings with a scan altitude (mapping::altitudeFor_m), a lane spacing and a scan speed that
    /// follow from resolution, overlap and scan altitude if they are 0. Over level ground, the beam at angle t from
    /// straight down meets the ground h pi/180 / cos^2 t from its neighbor, for a height h and the stock scanner's
    /// degree between beams; a scan comes every 0.2 s. The scanner's reach and the limits of the two parameters hold.
    Settings asAsked() const;

    /// The parameters that the user can set, with their limits and help texts.
    static const agent::ParameterTable<Settings> parameters;
    bool operator==(const Settings&) const = default;
};

} // namespace usar::airrobot
