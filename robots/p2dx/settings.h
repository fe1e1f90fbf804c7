// What people may set about a P2DX that explores, as one value.
#pragma once

#include <vector>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::p2dx {

/// SI units. Copied by value: new parameters take effect at the next tick.
struct Settings {
    double cruise_speed_m_s = 0.5;
    double safety_distance_m = 0.6; ///< of the thesis's behavior, from the scanner
    double low_distance_m = 0.3;
    double strip_width_m = 0.6;
    double side_lead_pct = 10.0;
    double keep_straight_s = 3.0;
    double back_distance_m = 0.35;
    double turn_rad = radians(60.0);
    double turn_rate_rad_s = 0.8;
    double steepest_descent_rad = radians(10.0);
    double trap_time_s = 20.0;
    double trap_radius_m = 0.8;
    double rest_time_s = 3.0;
    double drive_time_s = 0.0;
    bool operator==(const Settings&) const = default;
};

/// What a form shows; defaults are those of `Settings`.
const std::vector<agent::ParameterSpec>& parameterSpecs();
/// `parameters` were made from `parameterSpecs`.
Settings settingsFrom(const agent::ParameterSet& parameters);

} // namespace usar::p2dx
