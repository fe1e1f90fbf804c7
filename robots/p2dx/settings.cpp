#include "robots/p2dx/settings.h"

namespace usar::p2dx {

namespace {

using S = Settings;

constexpr agent::ParameterRow<Settings> rows[]{
    {&S::cruise_speed_m_s, "cruise_speed_m_s", "Cruise speed", "Driving", "m/s", 0.05, 1.6,
     "Speed where the way is free; the robot is slower near obstacles and downhill."},
    {&S::side_lead_pct, "side_lead_pct", "Lead of a new direction", "Driving", "%", 0, 100,
     "Another third of the view is chosen only if it is more open than the present one by this share."},
    {&S::keep_straight_s, "keep_straight_s", "Straight after a turn", "Driving", "s", 0, 60,
     "Time after a turn in which the robot drives straight on, however open the sides are."},
    {&S::drive_time_s, "drive_time_s", "Drive for", "Driving", "s", 0, 86400,
     "The behavior ends after this time; with 0, the user ends it."},
    {&S::safety_distance_m, "safety_distance_m", "Safety distance", "Danger", "m", 0.3, 5,
     "An object that the scanner sees in the strip ahead, nearer than this, is too close."},
    {&S::low_distance_m, "low_distance_m", "Low objects", "Danger", "m", 0.12, 0.8,
     "An echo of the front sonars nearer than this is too close. They find objects that lie below the scanner."},
    {&S::strip_width_m, "strip_width_m", "Strip ahead", "Danger", "m", 0.4, 2,
     "Width of the strip that must be free for the robot, which is 0.44 m wide."},
    {&S::steepest_descent_rad, "steepest_descent_rad", "Steepest descent", "Danger", "rad", radians(2), radians(40),
     "Ground that falls more steeply than this is too steep, because the robot would tip forward."},
    {&S::back_distance_m, "back_distance_m", "Way back", "Getting out", "m", 0, 2,
     "How far the robot backs away, at most as far as it came straight."},
    {&S::turn_rad, "turn_rad", "Turn", "Getting out", "rad", radians(10), radians(180),
     "How far the robot turns away at least; it goes on until the way is free."},
    {&S::turn_rate_rad_s, "turn_rate_rad_s", "Turn rate", "Getting out", "rad/s", 0.1, 3, "How fast it turns."},
    {&S::trap_time_s, "trap_time_s", "Trapped after", "Getting out", "s", 3, 600,
     "Time in one place after which the robot turns around."},
    {&S::trap_radius_m, "trap_radius_m", "One place", "Getting out", "m", 0.1, 10,
     "Distance that the robot must get away within that time."},
    {&S::rest_time_s, "rest_time_s", "Rest at the start", "Start", "s", 0, 60,
     "Time at rest before it drives off, which its INS needs."},
};

} // namespace

constinit const agent::ParameterTable<Settings> Settings::parameters{rows};

} // namespace usar::p2dx
