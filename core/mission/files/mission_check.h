// Checks of a mission before anything moves.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/mission_file.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// The behavior of a mission, found among the plugins, and its checked parameters.
struct PreparedBehavior {
    const agent::RobotPlugin* plugin = nullptr; ///< owned by the PluginLoader
    agent::ParameterSet parameters;
    std::optional<agent::PlanText> plan; ///< the user's own plan, if one was given
};

/// Fails on an unknown behavior, a wrong parameter, a missing area if one is needed, a plan that cannot be read, has
/// errors or does not fit the robot, or a plan for a behavior that is not decided by one. Errors about a mission that
/// was read from a file name line and column, here and in the other checks.
Result<PreparedBehavior> prepareBehavior(const Mission& mission, const agent::PluginLoader& plugins);

/// The parameters of a mission in the units of its behavior: the values of its preset, and its own in their place.
/// Fails on a preset that the behavior does not have.
Result<std::map<std::string, agent::ParameterValue>> resolvedParameters(const Mission& mission,
                                                                        const agent::BehaviorDescription& behavior);

/// Reads the plan in the file at `path` and checks it against the robot of the behavior; nullopt for an empty path.
/// Fails if the behavior is unknown or takes no plan, or the plan cannot be read, has errors or does not fit.
Result<std::optional<agent::PlanText>> readOwnPlan(const QString& path, const std::string& behavior_id,
                                                   const agent::PluginLoader& plugins);

/// Fails on an area that is entirely outside the world (meters, map frame). An empty area is accepted, and so is an
/// empty world, which is one of unknown size.
Result<void> checkAreaInWorld(const Rectangle& area_in_map, const Rectangle& world_in_map);
Result<void> checkAreaInWorld(const Mission& mission, const Rectangle& world_in_map);

/// A sentence that warns of the part of the area that is outside the world and cannot be flown; empty if there is none,
/// or if the world is empty, which is one of unknown size.
std::string beyondWorldNotice(const Rectangle& area_in_map, const Rectangle& world_in_map);
/// The part of the area that a robot can be sent to: the one inside the world, or all of it in a world of unknown size.
/// Beyond the world's edge there is no ground, and no sensor sees the edge.
Rectangle areaWithin(const Rectangle& area_in_map, const Rectangle& world_in_map);

/// Creates the folder if it is missing, and fails if no file can be created there.
Result<void> checkFolderIsWritable(const QString& folder);

/// Start pose that the mission names, in the map frame; names are compared without regard to case. The error lists the
/// names that exist.
Result<Pose> startPoseOf(const Mission& mission, const protocol::StartPoses& poses);

/// Returns the id of a behavior that is controlled by a plan: `chosen`, or else the first such behavior of the same
/// robot. If there is none, returns `chosen`.
std::string plannedBehavior(const std::string& chosen, const agent::PluginLoader& plugins);

} // namespace usar::mission
