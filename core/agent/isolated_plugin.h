// A plugin whose code never runs in this program: a process of its own describes it and reckons its previews.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QSocketNotifier>
#include <QString>
#include <QTimer>

#include "core/agent/host_process.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// How long a process may take before it is given up and killed.
struct IsolationPatience {
    Seconds loading{5.0}; ///< starting the process, loading its libraries and the plugin, and its description
    Seconds preview{1.0};
    Seconds end{0.5}; ///< once it has hung up
};

/// Stands for the plugin where its description is asked for. Its behaviors are started as IsolatedBehavior, each in yet
/// another process; `createBehavior` is refused. Nothing here waits: the process is asked, and what it answers, how it
/// died or that it hangs (it is killed then) is told from the event loop. A preview that crashes or hangs ends the
/// process, which the next one starts anew. Lives on the GUI thread; hangs up when it goes, and the process ends by
/// that. Who is told must not end it there and then.
class IsolatedPlugin final : public RobotPlugin {
public:
    template <class Answer>
    using Told = std::function<void(Result<Answer>)>;

    IsolatedPlugin(QString program, QString file, const IsolationPatience& patience = {});
    ~IsolatedPlugin() override;
    Q_DISABLE_COPY_MOVE(IsolatedPlugin)

    /// Once, before all else: starts the process and has it load the plugin, within the patience for loading. The error
    /// says why that went wrong, by which signal it died say. May tell before it returns where there is no process at
    /// all.
    void describe(Told<void> told);
    /// Within the patience for a preview. Takes the place of the one that was asked for before, if that is not answered
    /// yet.
    void foretell(frames::Preview wanted, Told<TaskPreview> told);
    /// Nobody is to be told any more.
    void forgetPreview();

    /// Empty before it has been told.
    RobotDescription description() const override { return description_; }
    Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const override;
    /// Refused: see `foretell`.
    Result<TaskPreview> preview(const std::string& id, const BehaviorContext& context) const override;

private:
    enum class Doing { Nothing, Loading, Foretelling };

    void begin();
    void ask(const frames::Request& request, Doing doing);
    void goOn();
    void listen();
    void take(frames::Reply reply);
    /// The process has hung up: why will be known in a moment.
    void awaitEnd();
    void runOut();
    void lose(const std::string& what);
    void fail(Error error);
    void listenTo(int handle, void (IsolatedPlugin::*call)());
    void becomeDeaf();
    void hangUp();

    QString program_;
    QString file_;
    IsolationPatience allowed_;
    RobotDescription description_;
    std::unique_ptr<HostProcess> host_; ///< none after a crash
    std::unique_ptr<QSocketNotifier> ear_;
    QTimer patience_;
    Doing doing_ = Doing::Nothing;
    bool ending_ = false;                   ///< it has hung up
    Told<void> told_;                       ///< until it has been described
    std::optional<frames::Preview> wanted_; ///< to be asked for as soon as it is idle
    Told<TaskPreview> told_preview_;
};

} // namespace usar::agent
