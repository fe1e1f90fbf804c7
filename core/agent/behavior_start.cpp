#include "core/agent/behavior_start.h"

#include <utility>

#include "core/agent/plugins/guarded_plugin.h"
#include "core/agent/process/isolated_behavior.h"
#include "core/agent/watched_behavior.h"

namespace usar::agent {

Result<std::shared_ptr<RunningBehavior>> startBehavior(const PluginLoader& plugins, const std::string& behavior_id,
                                                       BehaviorContext context,
                                                       const std::optional<Isolation>& isolation) {
    const auto plugin = plugins.pluginFor(behavior_id);
    if (!plugin)
        return tl::unexpected(plugin.error());
    if (isolation)
        return std::make_shared<IsolatedBehavior>(
            isolation->program, frames::Start{.plugin_file = plugins.recordOf(behavior_id)->file.toStdString(),
                                              .behavior_id = behavior_id,
                                              .task = std::move(context.task),
                                              .parameters = context.parameters.values(),
                                              .plan = std::move(context.plan)});
    auto behavior = makeBehavior(**plugin, behavior_id, std::move(context));
    if (!behavior)
        return tl::unexpected(behavior.error());
    return std::make_shared<WatchedBehavior>(std::make_unique<BehaviorHost>(
        *std::move(behavior), behavior_id, plugins.robotOf(behavior_id)->sensors_needed));
}

} // namespace usar::agent
