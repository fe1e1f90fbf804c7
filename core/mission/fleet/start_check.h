// Whether a behavior can be started as a person wants it, before anything moves.
#pragma once

#include <map>
#include <string>

#include <QString>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// Where a behavior is to run.
struct StartPlace {
    QString level;           ///< of the server; empty: unknown
    Rectangle extent_in_map; ///< of the world, in meters; empty: unknown
};

/// An error for an unknown behavior, and for a parameter that is not allowed.
Result<agent::ParameterSet> checkParameters(const std::string& behavior_id,
                                            const std::map<std::string, agent::ParameterValue>& values,
                                            const agent::PluginLoader& plugins);

/// The checked parameters. An error for an unknown behavior, a missing area, one outside the world, or a parameter that
/// is not allowed.
Result<agent::ParameterSet> checkStart(const StartedBehavior& start, const agent::PluginLoader& plugins,
                                       const StartPlace& place);

/// Whether this mission can be flown there: world, plugin, parameters, area within the world. The parameters as the
/// behavior takes them. Errors about a mission that was read from a file name line and column.
Result<std::map<std::string, agent::ParameterValue>>
checkMission(const Mission& mission, const agent::PluginLoader& plugins, const StartPlace& place);

} // namespace usar::mission
