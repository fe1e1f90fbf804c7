// From a plugin to a behavior at work.
#pragma once

#include <memory>
#include <string>

#include "core/agent/plugin_loader.h"
#include "core/agent/running_behavior.h"

namespace usar::agent {

/// Makes the behavior and hands it to a thread of its own. Plugins are code of other people: what they throw or refuse
/// comes back as an error, and so does a behavior that no loaded plugin has.
Result<std::shared_ptr<RunningBehavior>> startBehavior(const PluginLoader& plugins, const std::string& behavior_id,
                                                       BehaviorContext context);

} // namespace usar::agent
