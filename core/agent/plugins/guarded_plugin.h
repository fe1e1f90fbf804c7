// Calls plugins such that their exceptions do not end the program.
#pragma once

#include <memory>
#include <string>

#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// Calls `createBehavior`. Turns an exception or a null result into an error that names the behavior.
Result<std::unique_ptr<Behavior>> makeBehavior(const RobotPlugin& plugin, const std::string& id,
                                               BehaviorContext context);

/// Calls `preview`. Turns an exception into such an error.
Result<TaskPreview> previewTask(const RobotPlugin& plugin, const std::string& id, const BehaviorContext& context);

} // namespace usar::agent
