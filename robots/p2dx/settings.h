// The settings of an exploring P2DX.
#pragma once

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::p2dx {

/// All values are in SI units, and angles and rates are magnitudes. Distances ahead are measured from the scanner or,
/// for low objects, from the front sonars; robots-and-worlds.md 3.2 says where they are on the hull. A `Settings` is
/// made from parameters by `parameters.settings(set)`; its defaults are the defaults of the parameters. Copied by
/// value: new parameters take effect at the next tick.
struct Settings {
    /// Speed where the way is free. The robot is slower near obstacles and downhill.
    double cruise_speed_m_s = 0.5;
    double safety_distance_m = 0.6; ///< least free distance ahead, from the scanner, as in the thesis
    double low_distance_m = 0.3;    ///< least echo of the front sonars
    double strip_width_m = 0.6;     ///< width of the strip ahead that must be free
    double side_lead_pct = 10.0;    ///< lead that another third needs to be chosen
    /// Time for which the robot drives straight ahead after a turn, however open the sides are.
    double keep_straight_s = 3.0;
    /// Distance that the robot backs away, but no farther than it came in a straight line.
    double back_distance_m = 0.35;
    double turn_rad = radians(60.0); ///< least turn away from a danger
    /// Yaw rate of a turn in place.
    double turn_rate_rad_s = 0.8;
    /// Steeper ground is avoided, because the robot would tip forward.
    double steepest_descent_rad = radians(10.0);
    double trap_time_s = 20.0; ///< the robot is trapped if it gets no farther than trap_radius_m in this time
    double trap_radius_m = 0.8;
    double rest_time_s = 3.0;  ///< rest before the start, for the INS
    double drive_time_s = 0.0; ///< duration of the behavior; 0 means until the user ends it

    /// The parameters that the user can set, with their limits and help texts.
    static const agent::ParameterTable<Settings> parameters;
    bool operator==(const Settings&) const = default;
};

} // namespace usar::p2dx
