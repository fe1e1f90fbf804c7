// The settings of a Submarine that follows the bottom.
#pragma once

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::submarine {

/// All values are in SI units. Heights are over the bottom straight below, pitch angles are magnitudes, and distances
/// that the robot travels are its own estimates (see PitchModel). A `Settings` is made from parameters by
/// `parameters.settings(set)`; its defaults are the defaults of the parameters. [T] marks values from the thesis
/// (3.5.1). Copied by value: new parameters take effect at the next tick.
struct Settings {
    double height_m = 4.0;       ///< [T] height over the bottom
    double level_band_m = 0.6;   ///< the robot counts as level within this distance of the height
    double propeller_pct = 80.0; ///< share of the greatest speed
    bool knows_slant = true;     ///< false: the thesis's robot, which takes the ray for vertical
    /// Greatest angles of the nose downward and upward, by the robot's own estimate.
    double steepest_dive_rad = radians(20.0);
    double steepest_climb_rad = radians(25.0);
    double deepest_search_m = 40.0; ///< how far to dive without an echo before giving up
    double change_side_s = 100.0;   ///< [T] time between changes of the side to turn to
    double least_height_m = 0.5;    ///< [T] the robot backs off below this height
    /// The robot also backs off if the bottom, rising as it does now, would come too near within this time.
    double foresight_s = 7.5;
    /// Distance that the robot moves backward from danger, by its own estimate.
    double back_off_m = 8.0;
    /// Distance that it then returns, to where it could follow the bottom. It also returns from shallows and where the
    /// bottom falls out of reach.
    double way_back_m = 30.0;
    double sweep_s = 40.0;    ///< time of the camera from one side to the other
    double dive_time_s = 0.0; ///< duration of the behavior; 0 means until the user ends it

    /// The parameters that the user can set, with their limits and help texts.
    static const agent::ParameterTable<Settings> parameters;
    bool operator==(const Settings&) const = default;
};

} // namespace usar::submarine
