// Publishes the marks on the height map (thesis figure 4.4) and the values that the map and the status strip show.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "robots/airrobot/flight/evasion.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// Returns whether the scan may be written into the map: the robot must be level, not turn quickly, and be high enough
/// that the rays are not nearly horizontal. Scans in transit are as good as those on a lane; scans on the ground are
/// not used.
bool goodForMap(const Senses& senses, bool airborne, const Settings& settings);

/// Publishes only what changed. Owned by one robot.
class FlightLog {
public:
    /// Marks a place (map frame) at the robot's present height.
    void mark(agent::MarkKind kind, const Vec2& place_m, const Senses& senses, agent::CommandPort& port) const;
    /// Publishes the pose, a path mark every meter, and the scan if it is good for the map.
    void tick(const Senses& senses, bool airborne, const Settings& settings, agent::CommandPort& port);
    /// Marks new risks and diversions.
    void risks(const Senses& senses, const EvasionDecision& decision, agent::CommandPort& port) const;
    /// Publishes a goal that differs from the last one; nullopt means that there is no goal.
    void goal(std::optional<Vec3> goal_in_map_m, agent::CommandPort& port);
    /// Makes the path continue from the next position, because the position estimate has jumped.
    void forgetPath() { last_path_m_.reset(); }

private:
    std::optional<Vec3> last_path_m_;
    std::optional<Vec3> last_goal_m_;
};

} // namespace usar::airrobot
