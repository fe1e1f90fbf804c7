#include "core/mission/session/helm.h"

#include <chrono>
#include <utility>

#include "core/mission/hand/control_state.h"

namespace usar::mission {

Helm::Helm(QObject& qobject, HelmOwner& owner, const HelmView& view)
    : owner_(owner)
    , view_(view)
    , outgoing_([&owner](const agent::CausedCommand& command, std::string text) {
        owner.writeLine(command, std::move(text));
    })
    , hand_timer_(&qobject) {
    hand_timer_.setInterval(toMilliseconds(HandDriver::beat));
    hand_timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&hand_timer_, &QTimer::timeout, &hand_timer_, [this] { beat(); });
}

void Helm::beginConnection() {
    outgoing_.beginConnection();
    hand_.beginConnection();
    step_held_ = lockstep_ = false;
}

void Helm::sawSent(const protocol::Command& command) {
    outgoing_.sawSent(command);
    steps_sent_ += std::holds_alternative<protocol::Step>(command);
}

void Helm::describe(SessionFigures& figures) const {
    figures.steps_sent = steps_sent_;
    figures.lockstep = lockstep_;
    figures.dialect = outgoing_.dialect();
    figures.traffic.drives_replaced = outgoing_.drivesReplaced();
    figures.control = hand_.state();
    if (!host_)
        return;
    figures.control.behavior_id = host_->behaviorId();
    if (!hand_.on())
        figures.control.reins = Reins::Behavior;
}

void Helm::hear(std::string_view text, const protocol::InfoLine& line) {
    outgoing_.heard(text);
    hand_.take(line);
}

void Helm::answer(const protocol::InfoLine& line) {
    takeOutput(host_ ? host_->receive(line) : agent::RunningBehavior::Output{},
               std::holds_alternative<protocol::RobotState>(line.message));
}

void Helm::takeOutput(agent::RunningBehavior::Output output, bool is_tick) {
    const bool finishing = host_ && (host_->finished() || host_->ending());
    for (const agent::CausedCommand& command : output.commands)
        if (!hand_.on() || !protocol::isDrive(command.command))
            outgoing_.send(command);
    if (host_ && host_->ending()) {
        makeSafe(by::Behavior{host_->behaviorId(), "its process has ended"});
        output.append(host_->takeEnd());
    }
    if (is_tick)
        tickHand();
    if (is_tick && !finishing)
        endTick();
    owner_.takePublished(output.published);
    if (is_tick && finishing)
        endTick();
}

void Helm::endTick() {
    if (owner_.replaying())
        return;
    releaseDrives(false);
    if (lockstep_ && view_.spawning.done())
        step();
    owner_.flush();
}

void Helm::step() {
    step_held_ = halted();
    if (step_held_)
        return;
    outgoing_.send({protocol::Step{}, {by::Session{"lockstep"}, view_.incoming.stateLine()}});
    ++steps_sent_;
}

/// Sends the STEP that a halted plan has held back, once the plan runs again or has ended.
void Helm::stepOwed() {
    if (!step_held_ || halted())
        return;
    view_.vigil.forgive(owner_.wall()); // The silence was caused by us.
    step_held_ = false;
    if (!owner_.connected() || !lockstep_)
        return;
    step();
    owner_.flush();
}

void Helm::releaseDrives(bool at_once) {
    if (at_once || !owner_.congested())
        outgoing_.release(view_.incoming.now(), at_once);
}

void Helm::look() {
    if (!lockstep_ && !owner_.congested())
        releaseDrives(true);
}

void Helm::sendForSession(const protocol::Command& command, const char* why) {
    outgoing_.send({command, {by::Session{why}, {}}});
}

void Helm::sendForUser(const protocol::Command& command, const by::Source& source) {
    outgoing_.send({command, {source, view_.incoming.stateLine()}});
    releaseDrives(false);
    owner_.flush();
    owner_.touched();
}

void Helm::makeSafe(const by::Source& source) {
    if (!view_.spawning.done() || owner_.replaying())
        return;
    outgoing_.dropWaiting();
    std::optional<protocol::Command> safe;
    if (host_) {
        const agent::CausedCommand command = host_->safeCommand(source);
        safe = command.command;
        outgoing_.send(command);
    }
    for (const protocol::Command& stop : outgoing_.stops(safe, view_.incoming.kind()))
        outgoing_.send({stop, {source, view_.incoming.stateLine()}});
    releaseDrives(true);
    owner_.flush();
}

void Helm::stopBehavior(const by::Source& source, const std::string& reason) {
    makeSafe(source);
    if (host_)
        owner_.finishBehavior({false, reason}, false);
}

void Helm::start(std::shared_ptr<agent::RunningBehavior> host) {
    host_ = std::move(host);
    host_->setPatience(lockstep_ ? limits_.behavior.answer_in_lockstep : limits_.behavior.answer);
    agent::RunningBehavior::Output output = host_->begin();
    if (host_->endHandle() >= 0) {
        end_watch_ = std::make_unique<QSocketNotifier>(host_->endHandle(), QSocketNotifier::Read);
        QObject::connect(end_watch_.get(), &QSocketNotifier::activated, end_watch_.get(), [this] { behaviorEnded(); });
    }
    takeOutput(std::move(output), false);
}

/// Takes the end of a behavior that ended between two calls.
void Helm::behaviorEnded() {
    takeOutput(host_->takeEnd(), false);
    owner_.touched();
}

void Helm::order(agent::Order order) {
    if (!host_)
        return;
    if (order != agent::Order::Pause)
        endControl("the behavior " + host_->behaviorId() + " took over");
    takeOutput(host_->order(order), false);
    releaseDrives(false);
    stepOwed();
    owner_.flush();
    owner_.touched();
}

void Helm::control(const agent::PlanControl& control) {
    if (!host_) {
        if (const auto* const asked = std::get_if<agent::ReplacePlan>(&control))
            owner_.takePublished({agent::PlanReplaced{
                .fate = agent::PlanFate::Refused, .plan_name = asked->plan.name, .reason = "No behavior runs."}});
        return owner_.touched();
    }
    const bool was_halted = host_->halted();
    takeOutput(host_->control(control), false);
    releaseDrives(was_halted); // At the same protocol time as the safe command before it.
    stepOwed();
    owner_.flush();
    owner_.touched();
}

void Helm::setParameters(const agent::ParameterSet& parameters) {
    if (!host_)
        return;
    host_->setParameters(parameters);
    if (host_->ending())
        takeOutput({}, false);
}

bool Helm::dismiss() {
    if (end_watch_) { // It may be the object that has just signaled the end.
        end_watch_->setEnabled(false);
        end_watch_.release()->deleteLater();
    }
    const bool broke = host_ && host_->broke();
    host_.reset();
    stepOwed();
    return broke;
}

void Helm::takeControl() {
    if (hand_.on())
        return;
    if (halted())
        return view_.notices.say(Severity::Warning, Topic::Control,
                                 "The plan is halted, and the robot's time with it. Let the plan continue, then take "
                                 "control.");
    hand_.setOn(true);
    if (host_) {
        takeOutput(host_->order(agent::Order::Pause), false);
        view_.notices.say(Severity::Note, Topic::Control,
                          "You are driving. The behavior " + host_->behaviorId() +
                              " is paused; resume it to give it the robot back.");
    }
    makeSafe(by::Hand{"control taken"});
    sendByHand(hand_.question(view_.incoming.now()), false);
    owner_.flush();
    owner_.touched();
}

void Helm::endControl(const std::string& reason) {
    if (!hand_.on())
        return;
    endHold(reason);
    hand_.setOn(false);
    owner_.touched();
}

void Helm::drive(const HandIntent& intent) {
    const HandDriver::Change change = hand_.accept(intent, owner_.wall());
    if (change == HandDriver::Change::Ends) {
        endHold(lettingGo(intent.source));
    } else if (change == HandDriver::Change::Begins) {
        hand_timer_.start();
        beat();
    }
    owner_.touched();
}

void Helm::endHold(const std::string& reason) {
    hand_timer_.stop();
    if (!hand_.on())
        return;
    const HandCommands rest = hand_.stop(reason);
    if (view_.spawning.done() && owner_.connected() && !owner_.replaying()) {
        outgoing_.dropWaiting();
        sendByHand(rest, true);
        owner_.flush();
    }
    owner_.touched();
}

void Helm::beat() {
    if (!hand_.holding())
        return hand_timer_.stop();
    const Seconds wall = owner_.wall();
    if (const auto reason =
            hand_.reasonToStop(wall, limits_.hand, view_.vigil.silentFor(wall), view_.spawning.robotName()))
        return endHold(*reason);
    sendByHand(hand_.advance(), !owner_.congested());
    owner_.flush();
    owner_.touched();
}

void Helm::tickHand() {
    hand_.tick(owner_.wall());
    if (!hand_.on())
        return;
    sendByHand(hand_.question(view_.incoming.now()), false);
    sendByHand(hand_.repeat(view_.incoming.now()), false);
}

void Helm::sendByHand(const HandCommands& hand, bool at_once) {
    for (const protocol::Command& command : hand.commands)
        outgoing_.send({command, {hand.source, view_.incoming.stateLine()}});
    if (at_once)
        releaseDrives(true);
}

} // namespace usar::mission
