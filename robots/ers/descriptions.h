// Description and behaviors of the ERS, separate from the plugin class so that tests can link them.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::ers {

agent::RobotDescription describeErs();
/// Fails for an id that describeErs does not list.
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);

} // namespace usar::ers
