// Description and behaviors of the P2DX, separate from the plugin class so that tests can link them.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::p2dx {

agent::RobotDescription describeP2dx();
/// Fails for an id that describeP2dx does not list, and for a plan that cannot run on this robot.
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);

} // namespace usar::p2dx
