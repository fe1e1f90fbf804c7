// Calls into a plugin that keep what it throws from ending the program.
#pragma once

#include <memory>
#include <string>

#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// `createBehavior`, with an exception or a missing object turned into an error that names the behavior.
Result<std::unique_ptr<Behavior>> makeBehavior(const RobotPlugin& plugin, const std::string& id,
                                               BehaviorContext context);

/// `preview`, likewise.
Result<TaskPreview> previewTask(const RobotPlugin& plugin, const std::string& id, const BehaviorContext& context);

} // namespace usar::agent
