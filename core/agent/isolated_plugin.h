// A plugin whose code never runs in this program: a process of its own describes it and reckons its previews.
#pragma once

#include <memory>

#include "core/agent/host_process.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// Stands for the plugin where its description is asked for. Its behaviors are started as IsolatedBehavior, each in yet
/// another process; `createBehavior` is refused. A preview that crashes or hangs ends the process, which the next one
/// starts anew. Used from one thread, the GUI's, which waits for the answers: a preview takes as long as in this
/// program and 0.05 ms.
class IsolatedPlugin final : public RobotPlugin {
public:
    /// Starts the process and has it load the plugin. The error says why that went wrong, by which signal it died say.
    static Result<std::unique_ptr<IsolatedPlugin>> load(const QString& program, const QString& file);

    RobotDescription description() const override { return description_; }
    Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const override;
    Result<TaskPreview> preview(const std::string& id, const BehaviorContext& context) const override;

private:
    IsolatedPlugin(QString program, QString file) : program_(std::move(program)), file_(std::move(file)) {}
    /// `doing`: "being loaded".
    Result<frames::Reply> ask(const frames::Request& request, Seconds patience, const std::string& doing) const;
    Result<RobotDescription> begin() const;

    QString program_;
    QString file_;
    RobotDescription description_;
    mutable std::unique_ptr<HostProcess> host_; ///< none after a crash
};

} // namespace usar::agent
