// The thesis's threat zones (4.1, figure 4.1): the risk that each sonar reports, and the greatest of them.
#pragma once

#include <optional>
#include <vector>

#include "core/agent/published.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The threats of one tick.
struct ThreatPicture {
    std::vector<agent::SonarZone> zones;  ///< one for each sonar that is not silent, left to right
    agent::Risk risk = agent::Risk::None; ///< the highest risk of all
    /// The index of the greatest threat, which is the nearest echo with the highest risk; nullopt without a risk.
    std::optional<std::size_t> greatest;
};

/// Returns the ring of the threat-zone table for a bearing in the robot's frame: 0 in front to 4 at the sides and
/// behind.
std::size_t ringOf(double bearing_rad);

/// Judges the sonar echoes. An echo entirely below or above the body is not a threat; while braking, for example, the
/// cone points at the ground.
ThreatPicture judgeThreats(const Senses& senses, const Settings& settings);

/// True if no sonar hears a high risk near a way, whose bearing in the robot's frame is `way_rad`. What stands beside
/// it is no threat to a robot that knows its way.
bool isWayClear(const ThreatPicture& picture, double way_rad);

/// The same echoes, taken for harmless.
ThreatPicture noThreats(ThreatPicture picture);

} // namespace usar::airrobot
