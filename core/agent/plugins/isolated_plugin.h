// A plugin whose code never runs in this program: a process of its own describes it and computes its previews.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QSocketNotifier>
#include <QString>
#include <QTimer>

#include "core/agent/patience.h"
#include "core/agent/process/host_process.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// Represents the plugin for its description and previews. Its behaviors are started as IsolatedBehavior, each in yet
/// another process; `createBehavior` is refused. No call waits: the answer of the process, its death, or the fact that
/// it hangs (it is killed then) is reported from the event loop. A preview that crashes or hangs ends the process,
/// which the next preview starts again. Belongs to the GUI thread. The destructor closes the connection, on which the
/// process ends. Callbacks must not destroy this object.
class IsolatedPlugin final : public RobotPlugin {
public:
    /// A callback for a result.
    template <class Answer>
    using Told = std::function<void(Result<Answer>)>;

    IsolatedPlugin(QString program, QString file, const Patience& patience = {});
    ~IsolatedPlugin() override;
    Q_DISABLE_COPY_MOVE(IsolatedPlugin)

    /// Call it once, before anything else: starts the process and makes it load the plugin within the patience for
    /// loading. The error gives the reason, for example the signal by which the process died. `told` may be called
    /// before this returns if the process cannot be started.
    void describe(Told<void> told);
    /// Computes a preview within the patience for previews. Replaces a request that has not been answered yet.
    void foretell(frames::Job wanted, Told<TaskPreview> told);
    /// Cancels the callback of the last `foretell`.
    void forgetPreview();

    /// Empty until `describe` has succeeded.
    RobotDescription description() const override { return description_; }
    Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const override;
    /// Always an error; use `foretell`.
    Result<TaskPreview> preview(const std::string& id, const BehaviorContext& context) const override;

private:
    enum class Doing { Nothing, Loading, Foretelling };

    /// Starts the process and asks for the description.
    void begin();
    /// Sends a request and starts the timer.
    void ask(const frames::Request& request, Doing doing);
    void wait(Seconds patience) { patience_.start(std::chrono::round<std::chrono::milliseconds>(patience)); }
    /// Asks for the preview that is waiting, if any.
    void goOn();
    /// Handles a readable end handle.
    void listen();
    void take(frames::Reply reply);
    /// The process has closed the connection: waits for its end, which gives the reason.
    void awaitEnd();
    /// The patience is over, or the process has ended as awaited.
    void runOut();
    /// Drops the process and reports what it did ("died by …").
    void lose(const std::string& what);
    /// Reports an error to the callback that waits.
    void fail(Error error);
    void listenTo(int handle, void (IsolatedPlugin::*call)());
    void becomeDeaf();
    void hangUp();

    QString program_;
    QString file_;
    Patience allowed_;
    RobotDescription description_;
    std::unique_ptr<HostProcess> host_; ///< none after a crash
    std::unique_ptr<QSocketNotifier> ear_;
    QTimer patience_;
    Doing doing_ = Doing::Nothing;
    bool ending_ = false;               ///< the process has closed the connection
    Told<void> told_;                   ///< until `describe` has been answered
    std::optional<frames::Job> wanted_; ///< to be requested as soon as the process is idle
    Told<TaskPreview> told_preview_;
};

} // namespace usar::agent
