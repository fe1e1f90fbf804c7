#include "core/mission/fleet/start_check.h"

#include "core/mission/files/mission_check.h"

namespace usar::mission {

Result<agent::ParameterSet> checkParameters(const std::string& behavior_id,
                                            const std::map<std::string, agent::ParameterValue>& values,
                                            const agent::PluginLoader& plugins) {
    const agent::BehaviorDescription* description = plugins.behavior(behavior_id);
    if (!description)
        return tl::unexpected(plugins.pluginFor(behavior_id).error());
    return agent::ParameterSet::make(description->parameters, values);
}

Result<agent::ParameterSet> checkStart(const StartedBehavior& start, const agent::PluginLoader& plugins,
                                       const StartPlace& place) {
    const agent::BehaviorDescription* description = plugins.behavior(start.id);
    if (!description)
        return tl::unexpected(plugins.pluginFor(start.id).error());
    if (description->needs_area && start.area_in_map.empty())
        return failure("it needs a mission area", description->name, "Draw one on the map with the area tool");
    if (const auto inside = checkAreaInWorld(start.area_in_map, place.extent_in_map); !inside)
        return tl::unexpected(inside.error());
    return checkParameters(start.id, start.parameters, plugins);
}

Result<std::map<std::string, agent::ParameterValue>>
checkMission(const Mission& mission, const agent::PluginLoader& plugins, const StartPlace& place) {
    const std::string level = place.level.toStdString();
    if (!level.empty() && mission.world != level)
        return tl::unexpected(atValue(mission, "world",
                                      {"this mission belongs to the world " + mission.world, "",
                                       "Here is " + level + "; connect to a server with " + mission.world}));
    if (const auto prepared = prepareBehavior(mission, plugins); !prepared)
        return tl::unexpected(prepared.error());
    if (const auto inside = checkAreaInWorld(mission, place.extent_in_map); !inside)
        return tl::unexpected(inside.error());
    return resolvedParameters(mission, *plugins.behavior(mission.behavior));
}

Result<void> checkLineTo(const RobotView* robot) {
    if (!robot)
        return failure("there is no connection to send it on", "", "Connect to a server first");
    if (robot->figures.replay)
        return failure("this is a recording, and nothing can be sent into it", "", "Connect to a server first");
    if (robot->link.state != link::LinkState::Connected)
        return failure("the connection is lost", robot->spawn.robot_name, "Wait until it is back, or connect again");
    return {};
}

} // namespace usar::mission
