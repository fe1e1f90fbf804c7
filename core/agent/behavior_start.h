// From a plugin to a behavior at work.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/agent/plugin_loader.h"
#include "core/agent/running_behavior.h"

namespace usar::agent {

/// How a behavior gets a process of its own.
struct Isolation {
    QString program; ///< path of usar-behavior-host
};

/// Makes the behavior and hands it to a thread of its own; or, isolated, prepares a process that makes it. Plugins are
/// code of other people: what they throw or refuse comes back as an error (isolated, from the process: as the
/// behavior's end), and so does a behavior that no loaded plugin has.
Result<std::shared_ptr<RunningBehavior>> startBehavior(const PluginLoader& plugins, const std::string& behavior_id,
                                                       BehaviorContext context,
                                                       const std::optional<Isolation>& isolation = {});

} // namespace usar::agent
