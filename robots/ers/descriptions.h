// What the ERS plugin offers, without the plugin: tests link this.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::ers {

agent::RobotDescription describeErs();
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);

} // namespace usar::ers
