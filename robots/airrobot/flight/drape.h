// The height profile of a fast flight: it begins to climb in time for what is known to stand ahead.
#pragma once

#include <optional>

#include "robots/airrobot/flight/height_atlas.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The way before a robot, in the map frame.
struct WayAhead {
    Vec2 from_m = Vec2::Zero();
    double bearing_rad = 0.0;
    double speed_m_s = 0.0;
    double straight_m = 1e9; ///< length up to where the robot turns
};

/// Returns the height (map z) that the robot needs now, so that it is over everything known on the next 30 m by the
/// clearance when it gets there: what is far ahead may be higher by as much as the robot climbs on its way there.
/// nullopt if nothing is known.
std::optional<double> drapedHeight_m(const HeightAtlas& atlas, const WayAhead& way, const Settings& settings);

/// Whether the robot may sink as fast as it can: it knows the heights of the next meters, if only within the drift from
/// an earlier flight, or is so high over the ground below, `height_m`, that even a tall tree ahead would be below it.
/// Otherwise it would be too high to see the ground of a ravine, and would not get to know that there is room in it.
bool maySinkFast(const HeightAtlas& atlas, const WayAhead& way, double height_m);

} // namespace usar::airrobot
