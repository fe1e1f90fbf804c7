#include "core/agent/behavior_start.h"

#include <exception>
#include <utility>

#include "core/agent/process/isolated_behavior.h"
#include "core/agent/watched_behavior.h"

namespace usar::agent {

namespace {

constexpr const char* remedy = "Choose another behavior, or fix its plugin";

template <class Call>
auto guarded(const std::string& id, const Call& call) -> decltype(call()) {
    try {
        return call();
    } catch (const std::exception& thrown) {
        return failure(std::string("its plugin threw: ") + thrown.what(), "behavior " + id, remedy);
    } catch (...) {
        return failure("its plugin threw something that is no std::exception", "behavior " + id, remedy);
    }
}

} // namespace

Result<std::unique_ptr<Behavior>> makeBehavior(const RobotPlugin& plugin, const std::string& id,
                                               BehaviorContext context) {
    return guarded(id, [&]() -> Result<std::unique_ptr<Behavior>> {
        auto made = plugin.createBehavior(id, std::move(context));
        if (made && !*made)
            return failure("its plugin made none and did not say why", "behavior " + id, remedy);
        return made;
    });
}

Result<TaskPreview> previewTask(const RobotPlugin& plugin, const std::string& id, const BehaviorContext& context) {
    return guarded(id, [&] { return plugin.preview(id, context); });
}

Result<std::shared_ptr<RunningBehavior>> startBehavior(const PluginLoader& plugins, const std::string& behavior_id,
                                                       BehaviorContext context,
                                                       const std::optional<QString>& host_program,
                                                       BehaviorThread thread) {
    const auto plugin = plugins.pluginFor(behavior_id);
    if (!plugin)
        return tl::unexpected(plugin.error());
    if (host_program)
        return std::make_shared<IsolatedBehavior>(
            *host_program, frames::Start{plugins.recordOf(behavior_id)->file.toStdString(),
                                         {behavior_id, std::move(context.task), context.parameters.values(),
                                          std::move(context.plan)}});
    auto behavior = makeBehavior(**plugin, behavior_id, std::move(context));
    if (!behavior)
        return tl::unexpected(behavior.error());
    auto host =
        std::make_unique<BehaviorHost>(*std::move(behavior), behavior_id, plugins.robotOf(behavior_id)->sensors_needed);
    if (thread == BehaviorThread::Callers)
        return std::shared_ptr<RunningBehavior>(std::move(host));
    return std::make_shared<WatchedBehavior>(std::move(host));
}

} // namespace usar::agent
