// The thesis's threat zones (4.1, figure 4.1): which sonar says low or high risk, and which is the worst.
#pragma once

#include <optional>
#include <vector>

#include "core/agent/published.h"
#include "robots/airrobot/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

struct ThreatPicture {
    std::vector<agent::SonarZone> zones;  ///< one an echo, left to right
    agent::Risk risk = agent::Risk::None; ///< the worst of all
    /// Index of the greatest threat: the nearest echo among those of the worst risk.
    std::optional<std::size_t> greatest;
};

/// Ring of the threat-zone table that a bearing belongs to: 0 in front … 4 at the sides and behind.
std::size_t ringOf(double bearing_rad);

/// An echo wholly below or above the body (the cone points at the ground while braking) is no threat.
ThreatPicture judgeThreats(const Senses& senses, const Settings& settings);

} // namespace usar::airrobot
