#include "core/agent/isolated_plugin.h"

#include <utility>

#include <QFileInfo>

#include "core/base/numbers.h"

namespace usar::agent {

namespace {

/// Of a process, its libraries and the plugin's constructor; the GUI waits for it.
constexpr Seconds patience_for_loading{5.0};
constexpr Seconds patience_for_a_preview{1.0};

} // namespace

Result<std::unique_ptr<IsolatedPlugin>> IsolatedPlugin::load(const QString& program, const QString& file) {
    std::unique_ptr<IsolatedPlugin> plugin(new IsolatedPlugin(program, file));
    auto description = plugin->begin();
    if (!description)
        return tl::unexpected(description.error());
    plugin->description_ = *std::move(description);
    return plugin;
}

Result<RobotDescription> IsolatedPlugin::begin() const {
    auto started = HostProcess::start(program_, "plugin " + QFileInfo(file_).fileName().toStdString());
    if (!started)
        return tl::unexpected(started.error());
    host_ = *std::move(started);
    auto reply = ask(frames::Describe{file_.toStdString()}, patience_for_loading, "being loaded");
    if (!reply)
        return tl::unexpected(reply.error());
    return std::get<frames::Description>(*std::move(reply)).robot;
}

Result<frames::Reply> IsolatedPlugin::ask(const frames::Request& request, Seconds patience,
                                          const std::string& doing) const {
    const auto wrong = [&](const std::string& what) {
        host_.reset();
        return failure("it " + what + " while " + doing + " in a process of its own",
                       "plugin " + QFileInfo(file_).fileName().toStdString(), "Mend it and build it again");
    };
    std::optional<frames::Reply> reply;
    if (host_->ask(request, patience, reply) == FrameChannel::Received::TimedOut) {
        host_->kill();
        return wrong("did not answer for " + fixed(patience.count(), 0) + " s");
    }
    if (!reply)
        return wrong(host_->howItEnded(std::nullopt));
    if (const auto* const dying = std::get_if<frames::Dying>(&*reply))
        return wrong(host_->howItEnded(dying->signal));
    if (auto* const refusal = std::get_if<frames::Refusal>(&*reply))
        return tl::unexpected(std::move(refusal->error));
    if (std::holds_alternative<frames::Answer>(*reply))
        return wrong("answered what nobody had asked");
    return *std::move(reply);
}

Result<std::unique_ptr<Behavior>> IsolatedPlugin::createBehavior(const std::string& id, BehaviorContext) const {
    return failure("its plugin is not loaded into this program", "behavior " + id,
                   "Start it in a process of its own, or untick that for its plugin");
}

Result<TaskPreview> IsolatedPlugin::preview(const std::string& id, const BehaviorContext& context) const {
    if (!host_)
        if (const auto begun = begin(); !begun)
            return tl::unexpected(begun.error());
    auto reply = ask(frames::Preview{id, context.task, context.parameters.values(), context.plan},
                     patience_for_a_preview, "foretelling a task");
    if (!reply)
        return tl::unexpected(reply.error());
    if (auto* const preview = std::get_if<TaskPreview>(&*reply))
        return std::move(*preview);
    return failure("its answer is no preview", "behavior " + id, "Install the program and its host from one version");
}

} // namespace usar::agent
