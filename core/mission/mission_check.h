// What can be said against a mission before anything moves.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "core/agent/plugin_loader.h"
#include "core/mission/mission_file.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// A mission's behavior, found and with its parameters checked.
struct PreparedBehavior {
    const agent::RobotPlugin* plugin = nullptr;
    agent::ParameterSet parameters;
    std::optional<agent::PlanText> plan; ///< a person's own
};

/// Fails on an unknown behavior, a wrong parameter, no area where one is needed, a plan that cannot be read, has errors
/// or does not fit the robot, or a plan for a behavior that none decides. Like all errors about a mission that was read
/// from a file, these name line and column.
Result<PreparedBehavior> prepareBehavior(const Mission& mission, const agent::PluginLoader& plugins);

/// The plan in that file, checked against the robot of the behavior; nothing for an empty path.
Result<std::optional<agent::PlanText>> readOwnPlan(const QString& path, const std::string& behavior_id,
                                                   const agent::PluginLoader& plugins);

/// Fails on an area that is not wholly inside the world; an empty world is one whose size nobody knows.
Result<void> checkAreaInside(const Rectangle& area_in_map, const Rectangle& world_in_map);
Result<void> checkAreaInside(const Mission& mission, const Rectangle& world_in_map);

/// Makes the folder if it is missing and writes a file of no bytes there to try.
Result<void> checkFolderIsWritable(const QString& folder);

/// The pose that the mission names, compared without regard to case; the error lists the names that are there.
Result<Pose> startPoseOf(const Mission& mission, const protocol::StartPoses& poses);

} // namespace usar::mission
