#include "core/agent/plugins/isolated_plugin.h"

#include <utility>

#include <QFileInfo>

#include "core/base/numbers.h"

namespace usar::agent {

IsolatedPlugin::IsolatedPlugin(QString program, QString file, const Patience& patience)
    : program_(std::move(program))
    , file_(std::move(file))
    , allowed_(patience) {
    patience_.setSingleShot(true);
    patience_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&patience_, &QTimer::timeout, &patience_, [this] { runOut(); });
}

IsolatedPlugin::~IsolatedPlugin() {
    ear_.reset();
    hangUp();
}

void IsolatedPlugin::hangUp() {
    becomeDeaf();
    if (host_)
        host_->leave();
    host_.reset();
}

void IsolatedPlugin::describe(Told<void> told) {
    told_ = std::move(told);
    begin();
}

void IsolatedPlugin::foretell(frames::Job wanted, Told<TaskPreview> told) {
    wanted_ = std::move(wanted);
    told_preview_ = std::move(told);
    if (doing_ == Doing::Nothing)
        goOn();
}

void IsolatedPlugin::forgetPreview() {
    wanted_.reset();
    told_preview_ = nullptr;
}

void IsolatedPlugin::begin() {
    auto started = HostProcess::start(program_, "plugin " + QFileInfo(file_).fileName().toStdString());
    if (!started) {
        doing_ = Doing::Loading;
        return fail(started.error());
    }
    host_ = *std::move(started);
    listenTo(host_->endHandle(), &IsolatedPlugin::listen);
    ask(frames::Describe{file_.toStdString()}, Doing::Loading);
}

void IsolatedPlugin::ask(const frames::Request& request, Doing doing) {
    doing_ = doing;
    wait(doing == Doing::Loading ? allowed_.loading : allowed_.preview);
    if (!host_->tell(request))
        awaitEnd();
}

void IsolatedPlugin::goOn() {
    if (!wanted_)
        return;
    if (!host_)
        return begin();
    ask(*std::exchange(wanted_, std::nullopt), Doing::Foretelling);
}

void IsolatedPlugin::listen() {
    std::optional<frames::Reply> reply;
    if (host_->listen(reply) == FrameChannel::Received::TimedOut)
        return; // only a part has arrived
    if (!reply)
        return awaitEnd();
    if (const auto* const dying = std::get_if<frames::Dying>(&*reply))
        return lose(host_->howItEnded(dying->signal));
    if (doing_ == Doing::Nothing)
        return lose({});
    take(*std::move(reply));
}

void IsolatedPlugin::take(frames::Reply reply) {
    patience_.stop();
    if (auto* const refusal = std::get_if<Error>(&reply))
        return fail(std::move(*refusal));
    if (auto* const told = std::get_if<RobotDescription>(&reply); told && doing_ == Doing::Loading) {
        doing_ = Doing::Nothing;
        description_ = std::move(*told);
        if (const auto tell = std::exchange(told_, nullptr))
            return tell({});
        return goOn();
    }
    auto* const preview = std::get_if<TaskPreview>(&reply);
    if (!preview || doing_ != Doing::Foretelling)
        return lose("answered what nobody had asked");
    doing_ = Doing::Nothing;
    if (wanted_)
        return goOn(); // with the newer request
    if (const auto tell = std::exchange(told_preview_, nullptr))
        tell(std::move(*preview));
}

void IsolatedPlugin::awaitEnd() {
    ending_ = true;
    wait(allowed_.end);
    listenTo(host_->processHandle(), &IsolatedPlugin::runOut);
}

void IsolatedPlugin::runOut() {
    if (ending_)
        return lose(host_->howItEnded(std::nullopt, Seconds{0.0}));
    host_->kill();
    lose("did not answer for " + shortest(Seconds(patience_.intervalAsDuration()).count()) + " s");
}

void IsolatedPlugin::lose(const std::string& what) {
    patience_.stop();
    hangUp();
    ending_ = false;
    if (doing_ == Doing::Nothing)
        return; // the next preview starts it again
    fail({"it " + what + " while " + (doing_ == Doing::Loading ? "being loaded" : "previewing a task") +
              " in a separate process",
          "plugin " + QFileInfo(file_).fileName().toStdString(), "Fix it and build it again"});
}

void IsolatedPlugin::fail(Error error) {
    const Doing done = std::exchange(doing_, Doing::Nothing);
    if (done == Doing::Loading)
        hangUp(); // the process runs but is of no use
    if (const auto tell = std::exchange(told_, nullptr))
        return tell(tl::unexpected(std::move(error)));
    if (done == Doing::Foretelling && wanted_)
        return goOn(); // the error belongs to an older request
    wanted_.reset();
    if (const auto tell = std::exchange(told_preview_, nullptr))
        tell(tl::unexpected(std::move(error)));
}

void IsolatedPlugin::listenTo(int handle, void (IsolatedPlugin::*call)()) {
    becomeDeaf();
    if (handle < 0)
        return;
    ear_ = std::make_unique<QSocketNotifier>(handle, QSocketNotifier::Read);
    QObject::connect(ear_.get(), &QSocketNotifier::activated, ear_.get(), [this, call] { (this->*call)(); });
}

/// Deletes the notifier later, because this may be called from its own signal.
void IsolatedPlugin::becomeDeaf() {
    if (!ear_)
        return;
    ear_->setEnabled(false);
    ear_->disconnect();
    ear_.release()->deleteLater();
}

Result<std::unique_ptr<Behavior>> IsolatedPlugin::createBehavior(const std::string& id, BehaviorContext) const {
    return failure("its plugin is not loaded into this program", "behavior " + id,
                   "Start it in a separate process, or untick that for its plugin");
}

Result<TaskPreview> IsolatedPlugin::preview(const std::string& id, const BehaviorContext&) const {
    return failure("its plugin is not loaded into this program", "behavior " + id, "Ask the loader for the preview");
}

} // namespace usar::agent
