// What the Submarine plugin offers, without the plugin: tests link this.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::submarine {

agent::RobotDescription describeSubmarine();
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);

} // namespace usar::submarine
