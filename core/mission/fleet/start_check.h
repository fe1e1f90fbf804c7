// Checks, before anything moves, that a behavior can be started as requested.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <QString>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// The world in which a behavior is to run.
struct StartPlace {
    QString level;                       ///< name of the server's level; empty: unknown
    Rectangle extent_in_map;             ///< the world's extent in meters; empty: unknown
    std::optional<double> dry_above_m{}; ///< see agent::Task
};

/// Returns the checked parameters. An error for an unknown behavior, or for a parameter that is not allowed.
Result<agent::ParameterSet> checkParameters(const std::string& behavior_id,
                                            const std::map<std::string, agent::ParameterValue>& values,
                                            const agent::PluginLoader& plugins);

/// Returns the checked parameters. An error for an unknown behavior, an area that is missing or entirely outside the
/// world, or a parameter that is not allowed.
Result<agent::ParameterSet> checkStart(const StartedBehavior& start, const agent::PluginLoader& plugins,
                                       const StartPlace& place);

/// Checks that the mission can be flown there: world, plugin, parameters, and area, of which some must be in the world.
/// Returns the parameters as the behavior takes them. Errors about a mission that was read from a file name line and
/// column.
Result<std::map<std::string, agent::ParameterValue>>
checkMission(const Mission& mission, const agent::PluginLoader& plugins, const StartPlace& place);

/// An error says why no line can be sent there now; null: there is no such connection.
Result<void> checkLineTo(const RobotView* robot);

} // namespace usar::mission
