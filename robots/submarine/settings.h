// What people may set about a Submarine that follows the bottom, as one value.
#pragma once

#include <vector>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"

namespace usar::submarine {

/// SI units; [T] is the thesis (3.5.1). Copied by value: new parameters take effect at the next tick.
struct Settings {
    double height_m = 4.0; ///< [T]
    double level_band_m = 0.6;
    double propeller_pct = 80.0;
    bool knows_slant = true;
    double steepest_dive_rad = radians(20.0);
    double steepest_climb_rad = radians(25.0);
    double deepest_search_m = 40.0;
    double change_side_s = 100.0; ///< [T]
    double least_height_m = 0.5;  ///< [T]
    double foresight_s = 7.5;
    double back_off_m = 8.0;
    double way_back_m = 30.0;
    double sweep_s = 40.0;
    double dive_time_s = 0.0;
    bool operator==(const Settings&) const = default;
};

/// What a form shows; defaults are those of `Settings`.
const std::vector<agent::ParameterSpec>& parameterSpecs();
/// `parameters` were made from `parameterSpecs`.
Settings settingsFrom(const agent::ParameterSet& parameters);

} // namespace usar::submarine
