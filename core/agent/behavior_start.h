// Calls plugins such that their exceptions do not end the program, and starts their behaviors.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QString>

#include "core/agent/plugins/plugin_loader.h"
#include "core/agent/running_behavior.h"

namespace usar::agent {

/// Calls `createBehavior`. Turns an exception or a null result into an error that names the behavior.
Result<std::unique_ptr<Behavior>> makeBehavior(const RobotPlugin& plugin, const std::string& id,
                                               BehaviorContext context);

/// Calls `preview`. Turns an exception into such an error.
Result<TaskPreview> previewTask(const RobotPlugin& plugin, const std::string& id, const BehaviorContext& context);

/// Whose thread makes the calls of a behavior. One of its own can be abandoned if the behavior hangs; in the caller's,
/// nobody has to be woken up for each tick, which takes longer than most behaviors think.
enum class BehaviorThread { Own, Callers };

/// Creates the behavior in `thread`, or, with `host_program` (path of usar-behavior-host), prepares a process that will
/// create it. Plugins are third-party code: if one throws or refuses, this returns an error (in an
/// isolated process, it ends the behavior instead). Also returns an error if no loaded plugin has the behavior.
Result<std::shared_ptr<RunningBehavior>> startBehavior(const PluginLoader& plugins, const std::string& behavior_id,
                                                       BehaviorContext context,
                                                       const std::optional<QString>& host_program = {},
                                                       BehaviorThread thread = BehaviorThread::Own);

} // namespace usar::agent
