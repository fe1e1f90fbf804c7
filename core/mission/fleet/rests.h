// Missions that were cut off, for robots that fly their rests.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/plugins/plugin_loader.h"
#include "core/base/result.h"
#include "core/mission/fleet/robot_view.h"
#include "core/mission/fleet/start_check.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// Where a fleet's missions begin.
struct MissionSite {
    const agent::PluginLoader& plugins;
    const StartPlace& place;
    const std::vector<protocol::StartPose>& start_poses;
};

/// The mission that the behavior flies, as the robot's recording notes it (noteOf). `seed`: of the embedded simulator.
/// Empty if no plugin has the behavior.
std::string missionNote(const RobotView& robot, const StartedBehavior& start, std::optional<std::uint64_t> seed,
                        const MissionSite& site);

/// Where and as what a robot is spawned that flies the rest; it has no name yet. An error if nothing is left, or if the
/// mission cannot be flown at this site.
Result<SpawnRequest> spawnRequestFor(const RecordedScan& earlier, const MissionSite& site);

/// What robots will fly that are being spawned for it.
class Rests {
public:
    void add(RobotId robot, std::shared_ptr<const RecordedScan> earlier) { rests_[robot] = std::move(earlier); }
    void remove(RobotId robot) { rests_.erase(robot); }
    /// Once, when the robot is there: the behavior to start on it, or why it cannot be started. Otherwise nullopt.
    std::optional<Result<StartedBehavior>> take(const RobotView& robot, const MissionSite& site);

private:
    std::map<RobotId, std::shared_ptr<const RecordedScan>> rests_;
};

} // namespace usar::mission
