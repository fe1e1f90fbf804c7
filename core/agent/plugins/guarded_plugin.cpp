#include "core/agent/plugins/guarded_plugin.h"

#include <exception>
#include <utility>

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

} // namespace usar::agent
