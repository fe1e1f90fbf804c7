// The marks on the height map (thesis figure 4.4) and the values that the map and the status strip live on.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "robots/airrobot/evasion.h"
#include "robots/airrobot/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// A scan may be written into the map while the robot is level, not turning quickly, and high enough that the rays are
/// not nearly horizontal. Transit is as good as a lane; only the ground is not.
bool goodForMap(const Senses& senses, bool airborne, const Settings& settings);

/// Publishes what changed. Owned by one robot.
class FlightLog {
public:
    void mark(agent::MarkKind kind, const Vec3& position_in_map_m, const Senses& senses,
              agent::CommandPort& port) const;
    /// Pose, the path's marks every metre, the scan if it is good for the map.
    void tick(const Senses& senses, bool airborne, const Settings& settings, agent::CommandPort& port);
    void risks(const Senses& senses, const EvasionDecision& decision, agent::CommandPort& port) const;
    void goal(std::optional<Vec3> goal_in_map_m, agent::CommandPort& port);
    /// The estimate has jumped; the path goes on from the new place.
    void forgetPath() { last_path_m_.reset(); }

private:
    std::optional<Vec3> last_path_m_;
    std::optional<Vec3> last_goal_m_;
};

} // namespace usar::airrobot
