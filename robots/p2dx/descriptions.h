// What the P2DX plugin offers, without the plugin: tests link this.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::p2dx {

agent::RobotDescription describeP2dx();
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);

} // namespace usar::p2dx
