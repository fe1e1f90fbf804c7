// Description and behaviors of the Submarine, separate from the plugin class so that tests can link them.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::submarine {

agent::RobotDescription describeSubmarine();
/// Fails for an id that describeSubmarine does not list.
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);

} // namespace usar::submarine
