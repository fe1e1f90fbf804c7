// Driving by hand: who has control, the repetition of commands, and every way in which a hold ends with a stop.
#include "core/mission/session/robot_session_private.h"

#include <algorithm>
#include <utility>

#include "core/mission/hand/hand_cause.h"

namespace usar::mission {

namespace {

constexpr Seconds beat = DriveGate::spacing; // protocol.md 9.2: DRIVE no more often than about 20 Hz.
constexpr Seconds shortest_silence{1.0};
constexpr Seconds longest_spacing{3.0}; // Longest time between two STA, at the slowest speed of a simulator.

} // namespace

void RobotSession::takeControl() {
    if (d_->refusedInReplay())
        return;
    if (!d_->figures.spawned || protocol::isStation(d_->request.class_name))
        return d_->trouble(Severity::Warning, "no robot", "There is no robot to drive. Spawn one first.");
    if (d_->hand.on())
        return;
    if (d_->host && d_->host->halted())
        return d_->say(Severity::Warning, "control",
                       "The plan stands still, and the robot's time with it. Let it go on, then take control.");
    d_->beginHand();
}

void RobotSession::giveControlBack() {
    d_->endHand("control was given back");
}

void RobotSession::drive(const HandIntent& intent) {
    if (!d_->replayer)
        d_->takeHand(intent);
}

void RobotSession::stopDriving(const QString& reason) {
    d_->stopHand(reason.toStdString());
}

void RobotSession::Private::setUpHand() {
    wall.start();
    hand_timer.setInterval(toMilliseconds(beat));
    hand_timer.setTimerType(Qt::PreciseTimer);
    connect(&hand_timer, &QTimer::timeout, &q, [this] { beatHand(); });
}

void RobotSession::Private::beginHand() {
    hand.setOn(true);
    if (host) {
        agent::RunningBehavior::Output output = host->order(agent::Order::Pause);
        takeOutput(output, false);
        say(Severity::Note, "control",
            "You drive. The behavior " + host->behaviorId() + " is paused; resume it to give it the robot back.");
    }
    makeSafe(handCause("control taken"));
    askForHand();
    link.flush();
    touched();
}

void RobotSession::Private::askForHand() {
    if (auto question = hand.question(figures.now))
        send({*std::move(question), {handCause("how it is driven"), state->line()}});
}

void RobotSession::Private::endHand(const std::string& reason) {
    if (!hand.on())
        return;
    stopHand(reason);
    hand.setOn(false);
    touched();
}

void RobotSession::Private::takeHand(const HandIntent& intent) {
    using Verdict = HandControl::Verdict;
    const bool held_before = hand.holding();
    const Verdict verdict = hand.accept(intent, wallTime());
    if (verdict == Verdict::Released) {
        stopHand("the " + wordOf(intent.source) + (intent.source == HandSource::Keys ? " were" : " was") + " let go");
    } else if (verdict == Verdict::Held && !held_before) {
        hand_timer.start();
        beatHand();
    }
    touched();
}

/// Called every 50 ms while a device holds the robot.
void RobotSession::Private::beatHand() {
    if (!hand.holding())
        return hand_timer.stop();
    if (hand.overdue(wallTime(), limits.hand))
        return stopHand("nothing was heard of the hand");
    // Slow simulated time is not silence.
    if (since_data.isValid() &&
        Seconds(static_cast<double>(since_data.elapsed()) / 1000.0) > std::max(shortest_silence, 4.0 * tick_spacing))
        return stopHand(request.robot_name + " is silent");
    sendHand(hand.advance(beat), handCause(hand.holderText()), !congested());
    link.flush();
    touched();
}

/// Called with each STA.
void RobotSession::Private::tickHand() {
    const Seconds now_by_wall = wallTime();
    tick_spacing = std::min(now_by_wall - last_tick, longest_spacing);
    last_tick = now_by_wall;
    if (!hand.on())
        return;
    askForHand();
    sendHand(hand.repeat(figures.now), handCause(hand.holderText()), false);
}

/// Brings the robot to rest at once. Devices must be released before they count again.
void RobotSession::Private::stopHand(const std::string& reason) {
    hand_timer.stop();
    if (!hand.on())
        return;
    const HandDriver::Commands rest = hand.stop(reason);
    if (figures.spawned && connected() && !replayer) {
        gate.reset();
        sendHand(rest, handCause("stop, " + reason), true);
        link.flush();
    }
    touched();
}

void RobotSession::Private::sendHand(const HandDriver::Commands& commands, const std::string& source, bool at_once) {
    for (const protocol::Command& command : commands)
        send({command, {source, state->line()}});
    if (at_once)
        sendDrive(true);
}

void RobotSession::Private::showControl() {
    figures.control = hand.state();
    if (!host)
        return;
    figures.control.behavior_id = host->behaviorId();
    if (!hand.on())
        figures.control.reins = Reins::Behavior;
}

} // namespace usar::mission
