#include "robots/airrobot/settings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mapping/coverage_path.h"
#include "core/protocol/usual_values.h"

namespace usar::airrobot {

namespace {

using S = Settings;

constexpr double least_altitude_m = 2.0;
constexpr double most_scan_speed_m_s = 2.0;
constexpr double least_scan_speed_m_s = 0.1;
constexpr double most_spacing_m = 40.0;
constexpr double least_spacing_m = 2.0;

constexpr agent::ParameterRow<Settings> rows[]{
    {&S::scan_altitude_m, "scan_altitude_m", "Scan altitude", "Flight", "m", S::by_resolution, 15,
     "Height that the robot keeps above the ground. Left to the resolution (0 in files), it is 16 times that, 10 m at "
     "most; otherwise 2 m at least.",
     "by resolution"},
    {&S::floor_level_m, "floor_level_m", "Floor level", "Flight", "m", S::chosen_floor_m, 5000,
     "The robot never sinks below this map height except to land. This keeps it out of ravines and water, which the "
     "scanner cannot see. Left to the robot (-500 in files), it is above the water by the clearance, or above "
     "the start where nobody knows the water.",
     "by the robot"},
    {&S::clearance_m, "clearance_m", "Clearance", "Flight", "m", 0.5, 6,
     "Height that the robot keeps above the highest known object below and ahead of it."},
    {&S::footprint_radius_m, "footprint_radius_m", "Footprint radius", "Flight", "m", 0.8, 5,
     "Objects within this distance count as below the robot."},
    {&S::maximum_height_m, "maximum_height_m", "Highest climb", "Flight", "m", 8, 100,
     "The robot climbs over an obstacle only up to this height above the ground."},
    {&S::scan_speed_m_s, "scan_speed_m_s", "Scan speed", "Flight", "m/s", S::by_resolution, most_scan_speed_m_s,
     "Speed along the lanes. Flying slowly makes a denser map. Left to the resolution (0 in files), two scans are as "
     "far apart as it says; otherwise 0.1 m/s at least.",
     "by resolution"},
    {&S::transit_speed_m_s, "transit_speed_m_s", "Transit speed", "Flight", "m/s", 0.1, 2,
     "Speed to the area, between lanes and on the way home."},
    {&S::climb_speed_m_s, "climb_speed_m_s", "Climb speed", "Flight", "m/s", 0.2, 2, "Greatest rate of climb."},
    {&S::descent_speed_m_s, "descent_speed_m_s", "Descent speed", "Flight", "m/s", 0.1, 2,
     "Greatest rate of descent in flight."},
    {&S::turn_rate_rad_s, "turn_rate_rad_s", "Turn rate", "Flight", "rad/s", radians(5), radians(100),
     "Greatest yaw rate. Quick turns make the INS drift more."},
    {&S::acceleration_m_s2, "acceleration_m_s2", "Acceleration", "Flight", "m/s²", 0.2, 4,
     "How quickly the commanded speed grows."},
    {&S::braking_m_s2, "braking_m_s2", "Braking", "Flight", "m/s²", 0.2, 4,
     "Deceleration from which safe speeds are computed."},
    {&S::safety_margin_m, "safety_margin_m", "Safety margin", "Flight", "m", 0.6, 3,
     "The robot stops at this distance from its center to an obstacle."},
    {&S::ground_resolution_m, "ground_resolution_m", "Ground resolution", "Survey", "m", 0.15, 2,
     "Greatest distance between two points of the map on level ground, where altitude, lane spacing and scan speed "
     "are left to it. Altitude and speed follow at once, the spacing when a survey is planned."},
    {&S::overlap_pct, "overlap_pct", "Overlap", "Survey", "%", 0, 80,
     "Share of the width of a lane's strip that the next lane's strip shows, too, where the lane spacing is left to "
     "the resolution. Overlap fills what crowns hide, and lets strips be compared."},
    {&S::lane_spacing_m, "lane_spacing_m", "Lane spacing", "Survey", "m", S::by_resolution, most_spacing_m,
     "Greatest distance between lanes. Left to the resolution (0 in files), it follows from that and the overlap; "
     "otherwise 2 m at least. Takes effect when a survey is planned.",
     "by resolution"},
    {&S::quadrant_limit_m, "quadrant_limit_m", "Quadrant limit", "Survey", "m", 20, 1000,
     "An area with a longer side is divided into quadrants. A robot that is to fly faster than 1.6 m/s leaves them out "
     "where "
     "its battery lasts longer without. Takes effect when a survey is planned."},
    {&S::goal_distance_m, "goal_distance_m", "Goal distance", "Survey", "m", 5, 200,
     "Greatest distance between goals on a lane. Giving up a goal loses no more of the lane than this."},
    {&S::goal_reached_m, "goal_reached_m", "Goal reached within", "Survey", "m", 0.5, 10,
     "A goal counts as reached within this distance."},
    {&S::lookahead_m, "lookahead_m", "Look-ahead", "Survey", "m", 1, 20, "How far ahead on the lane the robot aims."},
    {&S::least_gain_m, "least_gain_m", "Gain of extra lanes", "Survey", "m", 0.1, 1000,
     "After its lanes, the robot flies extra ones past what is hidden, each of which shows at least so many square "
     "meters per meter of the way that it costs, flights home for a charge included, and fewer in an area below 5900 "
     "m². The greatest value means none."},
    {&S::most_left_out_pct, "most_left_out_pct", "Left out at most", "Survey", "%", 0, 100,
     "A survey still succeeds if at most this share of its lanes is given up."},
    {&S::maximum_scan_tilt_rad, "maximum_scan_tilt_rad", "Largest tilt for the map", "Survey", "rad", 0.02, 0.8,
     "Scans taken at a greater tilt are not added to the map. A steady lean against the wind does not count."},
    {&S::maximum_scan_turn_rad_s, "maximum_scan_turn_rad_s", "Largest turn rate for the map", "Survey", "rad/s", 0.02,
     2, "Scans taken during a faster turn are not added to the map."},
    {&S::low_risk_0_m, "low_risk_0_m", "Low risk, M0", "Threat zones", "m", 0.2, 5,
     "An echo straight ahead is a low risk if it is nearer than this."},
    {&S::low_risk_1_m, "low_risk_1_m", "Low risk, L1 R1", "Threat zones", "m", 0.2, 5,
     "An echo 18 degrees to either side is a low risk if it is nearer than this."},
    {&S::low_risk_2_m, "low_risk_2_m", "Low risk, L2 R2", "Threat zones", "m", 0.2, 5,
     "An echo 36 degrees to either side is a low risk if it is nearer than this."},
    {&S::low_risk_3_m, "low_risk_3_m", "Low risk, L3 R3", "Threat zones", "m", 0.2, 5,
     "An echo 54 degrees to either side is a low risk if it is nearer than this."},
    {&S::low_risk_4_m, "low_risk_4_m", "Low risk, L4 R4", "Threat zones", "m", 0.2, 5,
     "An echo 72 degrees to either side is a low risk if it is nearer than this."},
    {&S::high_risk_0_m, "high_risk_0_m", "High risk, M0", "Threat zones", "m", 0.1, 5,
     "An echo straight ahead is a high risk if it is nearer than this."},
    {&S::high_risk_1_m, "high_risk_1_m", "High risk, L1 R1", "Threat zones", "m", 0.1, 5,
     "An echo 18 degrees to either side is a high risk if it is nearer than this."},
    {&S::high_risk_2_m, "high_risk_2_m", "High risk, L2 R2", "Threat zones", "m", 0.1, 5,
     "An echo 36 degrees to either side is a high risk if it is nearer than this."},
    {&S::high_risk_3_m, "high_risk_3_m", "High risk, L3 R3", "Threat zones", "m", 0.1, 5,
     "An echo 54 degrees to either side is a high risk if it is nearer than this."},
    {&S::high_risk_4_m, "high_risk_4_m", "High risk, L4 R4", "Threat zones", "m", 0.1, 5,
     "An echo 72 degrees to either side is a high risk if it is nearer than this."},
    {&S::evasion_speed_m_s, "evasion_speed_m_s", "Evasion speed", "Evasion", "m/s", 0.1, 2,
     "Speed away from a high risk, and toward a diversion point."},
    {&S::diversion_distance_m, "diversion_distance_m", "Diversion distance", "Evasion", "m", 1, 15,
     "Distance from the robot to a diversion point."},
    {&S::calm_cycles, "calm_cycles", "Calm cycles", "Evasion", "", 1, 100,
     "The robot returns to its goal after this time without a risk, in ticks of 0.2 s."},
    {&S::side_clearance_m, "side_clearance_m", "Side clearance", "Evasion", "m", 0.7, 6,
     "Half the width of the free path that a diversion needs."},
    {&S::climb_over, "climb_over", "Climb over obstacles", "Evasion", "", 0, 0,
     "The robot climbs over obstacles that it cannot fly around."},
    {&S::climb_over_after_s, "climb_over_after_s", "Climb over after", "Evasion", "s", 0, 120,
     "The robot climbs after this time without progress."},
    {&S::climb_standoff_m, "climb_standoff_m", "Climb stand-off", "Evasion", "m", 1, 6,
     "Distance to all obstacles that the robot seeks before a climb, because treetops are wider at the top."},
    {&S::give_up_after_s, "give_up_after_s", "Give up a goal after", "Evasion", "s", 10, 1000,
     "A goal is given up after this time without progress."},
    {&S::scan_memory_s, "scan_memory_s", "Scanner memory", "Evasion", "s", 5, 3600,
     "How long the robot avoids what its belly scanner saw."},
    {&S::sonar_memory_s, "sonar_memory_s", "Sonar memory", "Evasion", "s", 1, 600,
     "How long the robot avoids what its sonars heard."},
    {&S::battery_range_m, "battery_range_m", "Battery range", "Battery", "m", 50, 100000,
     "Distance that the simulated battery lasts."},
    {&S::battery_reserve_pct, "battery_reserve_pct", "Reserve", "Battery", "%", 0, 60,
     "Share of the range that is kept for avoiding obstacles on the way home."},
    {&S::recharge_time_s, "recharge_time_s", "Recharge time", "Battery", "s", 0, 3600,
     "Time on the ground that a charge takes."},
    {&S::robot_battery_reserve_s, "robot_battery_reserve_s", "Robot's battery reserve", "Battery", "s", 0, 3600,
     "The robot goes home for good when its own battery, which cannot be charged, lasts only for the way home and this "
     "time."},
    {&S::landing_speed_m_s, "landing_speed_m_s", "Touch-down speed", "Landing", "m/s", 0.1, 0.8,
     "Rate of descent near the ground."},
    {&S::landing_slow_below_m, "landing_slow_below_m", "Slow below", "Landing", "m", 1, 10,
     "Below this height, the robot lands slowly."},
    {&S::landing_radius_m, "landing_radius_m", "Landing place within", "Landing", "m", 0, 20,
     "The robot looks for level ground within this distance of the base."},
    {&S::correct_heading, "correct_heading", "Correct the heading", "Pose", "", 0, 0,
     "Corrects the drift of the INS's heading by the course that the robot flies, and tells it from wind."},
    {&S::navigate_by_truth, "navigate_by_truth", "Navigate by ground truth", "Pose", "", 0, 0,
     "The robot takes its pose from the simulator's ground truth instead of the INS, which drifts. No real robot can."},
    {&S::rest_time_s, "rest_time_s", "Rest on the ground", "Pose", "s", 2, 60,
     "Time at rest before take-off and before the INS is set."},
    {&S::reset_attempts, "reset_attempts", "INS reset attempts", "Pose", "", 1, 50,
     "Attempts to set the INS before the robot flies on without setting it."},
    {&S::sensor_timeout_s, "sensor_timeout_s", "Sensor time-out", "Pose", "s", 0.5, 20,
     "The robot hovers when a sensor has been silent for this time."},
};

} // namespace

double Settings::lowRisk_m(std::size_t ring) const {
    return std::array{low_risk_0_m, low_risk_1_m, low_risk_2_m, low_risk_3_m, low_risk_4_m}.at(ring);
}

double Settings::highRisk_m(std::size_t ring) const {
    return std::array{high_risk_0_m, high_risk_1_m, high_risk_2_m, high_risk_3_m, high_risk_4_m}.at(ring);
}

Settings Settings::asAsked() const {
    constexpr double beam_step_rad = radians(1.0);
    constexpr double scans_per_s = 5.0;
    constexpr double most_range_m = 0.95 * protocol::usual_scanner_maximum_m; // Ground is not quite level.
    Settings settings = *this;
    if (scan_speed_m_s <= by_resolution)
        settings.scan_speed_m_s = ground_resolution_m * scans_per_s;
    const double height_m = scan_altitude_m <= by_resolution ? mapping::altitudeFor_m(ground_resolution_m)
                                                             : std::max(scan_altitude_m, least_altitude_m);
    settings.scan_altitude_m = height_m;
    if (lane_spacing_m <= by_resolution) {
        const double square_cosine = std::min(1.0, height_m * beam_step_rad / ground_resolution_m);
        const double aside_m = height_m * std::sqrt(1.0 / square_cosine - 1.0);
        const double reach_m = std::sqrt(most_range_m * most_range_m - height_m * height_m);
        settings.lane_spacing_m = 2.0 * std::min(aside_m, reach_m) * (1.0 - overlap_pct / 100.0);
    }
    settings.scan_speed_m_s = std::clamp(settings.scan_speed_m_s, least_scan_speed_m_s, most_scan_speed_m_s);
    settings.lane_spacing_m = std::clamp(settings.lane_spacing_m, least_spacing_m, most_spacing_m);
    return settings;
}

constinit const agent::ParameterTable<Settings> Settings::parameters{rows};

} // namespace usar::airrobot
