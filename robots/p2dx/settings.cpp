#include "robots/p2dx/settings.h"

namespace usar::p2dx {

namespace {

using S = Settings;

constexpr agent::ParameterRow<Settings> rows[]{
    {&S::cruise_speed_m_s, "cruise_speed_m_s", "Cruise speed", "Driving", "m/s", 0.05, 1.6,
     "Speed where the way is free. The robot is slower near obstacles and downhill."},
    {&S::side_lead_pct, "side_lead_pct", "Steering hysteresis", "Driving", "%", 0, 100,
     "The robot heads for another third of the view only if it is more open than the present one by this share."},
    {&S::keep_straight_s, "keep_straight_s", "Straight after a turn", "Driving", "s", 0, 60,
     "Time for which the robot drives straight ahead after a turn, however open the sides are."},
    {&S::drive_time_s, "drive_time_s", "Drive for", "Driving", "s", 0, 86400,
     "The behavior ends after this time. With 0, it runs until you end it."},
    {&S::safety_distance_m, "safety_distance_m", "Safety distance", "Danger", "m", 0.3, 5,
     "An object in the strip ahead is too close if the scanner sees it nearer than this."},
    {&S::low_distance_m, "low_distance_m", "Low objects", "Danger", "m", 0.12, 0.8,
     "An echo of the front sonars is too close if it is nearer than this. Sonars hear objects below the scanner."},
    {&S::strip_width_m, "strip_width_m", "Strip ahead", "Danger", "m", 0.4, 2,
     "Width of the strip ahead that must be free. The robot is 0.44 m wide."},
    {&S::steepest_descent_rad, "steepest_descent_rad", "Steepest descent", "Danger", "rad", radians(2), radians(40),
     "Steeper ground is avoided, because the robot would tip forward."},
    {&S::back_distance_m, "back_distance_m", "Way back", "Getting out", "m", 0, 2,
     "Distance that the robot backs away, but no farther than it came in a straight line."},
    {&S::turn_rad, "turn_rad", "Turn", "Getting out", "rad", radians(10), radians(180),
     "Least angle of a turn away from a danger. The robot turns until the way is free."},
    {&S::turn_rate_rad_s, "turn_rate_rad_s", "Turn rate", "Getting out", "rad/s", 0.1, 3,
     "Yaw rate of a turn in place."},
    {&S::trap_time_s, "trap_time_s", "Trapped after", "Getting out", "s", 3, 600,
     "The robot turns around after this time in one place."},
    {&S::trap_radius_m, "trap_radius_m", "One place", "Getting out", "m", 0.1, 10,
     "The robot is in one place while it gets no farther than this."},
    {&S::rest_time_s, "rest_time_s", "Rest at the start", "Start", "s", 0, 60,
     "Time at rest before the robot starts, which its INS needs."},
};

} // namespace

constinit const agent::ParameterTable<Settings> Settings::parameters{rows};

} // namespace usar::p2dx
