#include "robots/submarine/settings.h"

namespace usar::submarine {

namespace {

using S = Settings;

constexpr agent::ParameterRow<Settings> rows[]{
    {&S::height_m, "height_m", "Height", "Level", "m", 1, 15, "Height that the robot keeps above the sea bottom."},
    {&S::level_band_m, "level_band_m", "Level within", "Level", "m", 0.1, 3,
     "Within this distance of that height, the robot counts as level and turns with its rudder."},
    {&S::knows_slant, "knows_slant", "Estimate pitch", "Level", "", 0, 0,
     "The robot estimates from its fins how much its hull and its ray are tilted. Without this it takes the ray for "
     "vertical, as in the thesis, dives as steeply as it can and hits the bottom below a cliff."},
    {&S::steepest_dive_rad, "steepest_dive_rad", "Steepest dive", "Level", "rad", radians(3), radians(40),
     "Steepest angle of the nose downward, by the robot's own estimate."},
    {&S::steepest_climb_rad, "steepest_climb_rad", "Steepest climb", "Level", "rad", radians(3), radians(40),
     "Steepest angle of the nose upward, by the robot's own estimate."},
    {&S::deepest_search_m, "deepest_search_m", "Deepest search", "Level", "m", 5, 500,
     "How far the robot dives without an echo before it gives up."},
    {&S::propeller_pct, "propeller_pct", "Propeller", "Driving", "%", 20, 100,
     "Share of the greatest propeller speed."},
    {&S::change_side_s, "change_side_s", "Other side after", "Driving", "s", 5, 3600,
     "Time after which the robot turns to the other side, so that it does not move in a circle."},
    {&S::dive_time_s, "dive_time_s", "Dive for", "Driving", "s", 0, 86400,
     "The behavior ends after this time. With 0, it runs until you end it."},
    {&S::least_height_m, "least_height_m", "Least height", "Danger", "m", 0.2, 3,
     "The robot backs off when it is nearer to the bottom than this."},
    {&S::foresight_s, "foresight_s", "Foresight", "Danger", "s", 0, 10,
     "The robot also backs off if the bottom, rising as it does now, would be that near after this time."},
    {&S::back_off_m, "back_off_m", "Back for", "Danger", "m", 1, 60,
     "How far the robot backs off, by its own estimate."},
    {&S::way_back_m, "way_back_m", "Way back", "Danger", "m", 15, 200,
     "How far the robot then returns, by its own estimate, to where it could follow the bottom. It also returns from "
     "shallows and where the bottom falls out of reach."},
    {&S::sweep_s, "sweep_s", "Sweep", "Camera", "s", 5, 600,
     "Time in which the camera pans from one side to the other. A slow mount takes longer."},
};

} // namespace

constinit const agent::ParameterTable<Settings> Settings::parameters{rows};

} // namespace usar::submarine
