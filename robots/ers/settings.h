// The settings of an ERS that follows a ball.
#pragma once

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::ers {

/// All values are in SI units. Strides are lengths of steps on the ground, in the direction in which the robot looks;
/// the picture is that of the camera in its head. A `Settings` is made from parameters by `parameters.settings(set)`;
/// its defaults are the defaults of the parameters. Copied by value: new parameters take effect at the next tick.
struct Settings {
    /// Length of a step of the outer paws, and how high a paw is lifted during it.
    double stride_m = 0.05;
    double lift_m = 0.012;
    double tight_share_pct = -80.0; ///< inner stride as a share of the outer one; negative values are steps backward
    double wide_share_pct = 50.0;   ///< the same for wide circles
    /// Time after which the robot changes from tight to wide circles, or back.
    double circle_s = 16.0;
    double steering = 1.5; ///< turn per tangent of the ball's angle to the side
    /// Time for which the robot walks on after a near ball left its sight. This is the kick.
    double kick_s = 4.0;
    double near_rad = radians(25.0); ///< the ball is near if the head looks down at it by more than this
    /// The robot leaves colored points along its path, one in each interval.
    bool trace = true;
    double trace_interval_s = 1.0;
    double play_time_s = 0.0; ///< duration of the behavior; 0 means until the user ends it

    /// The parameters that the user can set, with their limits and help texts.
    static const agent::ParameterTable<Settings> parameters;
    bool operator==(const Settings&) const = default;
};

} // namespace usar::ers
