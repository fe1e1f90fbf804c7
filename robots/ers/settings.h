// What people may set about an ERS that goes after a ball, as one value.
#pragma once

#include <string>
#include <vector>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::ers {

/// SI units. Copied by value: new parameters take effect at the next tick.
struct Settings {
    double stride_m = 0.05;
    double lift_m = 0.012;
    double tight_share_pct = -80.0;
    double wide_share_pct = 50.0;
    double circle_s = 16.0;
    double steering = 1.5;
    double kick_s = 4.0;
    double near_rad = radians(25.0);
    bool trace = true;
    double trace_interval_s = 1.0;
    double play_time_s = 0.0;
    bool operator==(const Settings&) const = default;
};

/// What a form shows; defaults are those of `Settings`.
const std::vector<agent::ParameterSpec>& parameterSpecs();
/// `parameters` were made from `parameterSpecs`.
Settings settingsFrom(const agent::ParameterSet& parameters);

} // namespace usar::ers
