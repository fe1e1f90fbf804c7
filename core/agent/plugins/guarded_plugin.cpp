#include "core/agent/plugins/guarded_plugin.h"

#include <exception>
#include <utility>

namespace usar::agent {

namespace {

template <class Call>
auto guarded(const std::string& id, const Call& call) -> decltype(call()) {
    const std::string mend = "Choose another behavior, or mend its plugin";
    try {
        return call();
    } catch (const std::exception& thrown) {
        return failure(std::string("its plugin threw: ") + thrown.what(), "behavior " + id, mend);
    } catch (...) {
        return failure("its plugin threw something that is no std::exception", "behavior " + id, mend);
    }
}

} // namespace

Result<std::unique_ptr<Behavior>> makeBehavior(const RobotPlugin& plugin, const std::string& id,
                                               BehaviorContext context) {
    return guarded(id, [&]() -> Result<std::unique_ptr<Behavior>> {
        auto made = plugin.createBehavior(id, std::move(context));
        if (made && !*made)
            return failure("its plugin made none and did not say why", "behavior " + id,
                           "Choose another behavior, or mend its plugin");
        return made;
    });
}

Result<TaskPreview> previewTask(const RobotPlugin& plugin, const std::string& id, const BehaviorContext& context) {
    return guarded(id, [&] { return plugin.preview(id, context); });
}

} // namespace usar::agent
