// Who moves the robot of a session, a behavior or the user's hand, and what is sent for them. Nothing else sends.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <QSocketNotifier>
#include <QTimer>

#include "core/agent/running_behavior.h"
#include "core/mission/commands/outgoing.h"
#include "core/mission/hand/hand_driver.h"
#include "core/mission/session/incoming.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/spawn_life.h"
#include "core/mission/session/vigil.h"

namespace usar::mission {

/// Interface of the session that the helm uses.
class HelmOwner {
public:
    virtual ~HelmOwner() = default;
    virtual void writeLine(const agent::CausedCommand& command, std::string text) = 0;
    /// Hands queued bytes to the network now.
    virtual void flush() = 0;
    virtual bool connected() const = 0;
    virtual bool replaying() const = 0;
    /// True while the server reads more slowly than we write.
    virtual bool congested() const = 0;
    virtual void takePublished(const std::vector<agent::Published>& published) = 0;
    /// The behavior has ended or must end, for this reason; the owner must call `Helm::dismiss`.
    virtual void finishBehavior(const agent::BehaviorFinished& finished, bool is_published) = 0;
    virtual void touched() = 0;
    /// Wall time since any moment that stays the same.
    virtual Seconds wall() const = 0;
};

/// The parts of a session that the helm reads or notifies.
struct HelmView {
    const Incoming& incoming;
    const SpawnLife& spawning;
    Notices& notices;
    Vigil& vigil;
};

/// Owns the behavior, the manual control and the unsent commands, and paces a server in lockstep: each STA is answered
/// with commands and then STEP. A hand that has control lets no DRIVE of a behavior through. Belongs to one session and
/// its thread.
class Helm {
public:
    /// `qobject` belongs to the session's thread; it, `owner` and what `view` refers to must outlive this object.
    Helm(QObject& qobject, HelmOwner& owner, const HelmView& view);

    void setLimits(const SessionLimits& limits) { limits_ = limits; }
    void beginConnection();
    void loseConnection() { lockstep_ = false; }
    /// Resets the step count because a replay starts again.
    void rewind() { steps_sent_ = 0; }
    /// Takes a replayed command that was sent in the recording.
    void sawSent(const protocol::Command& command);
    protocol::Dialect spelling() const { return outgoing_.spelling(); }
    void describe(SessionFigures& figures) const;

    /// `on`: the server has agreed to wait for a STEP after each STA.
    void setLockstep(bool on) { lockstep_ = on; }
    /// These lines come next, of which the first has this number; see RunningBehavior::expect.
    void expect(LineNumber first, std::span<const std::string_view> lines) {
        if (host_)
            host_->expect(first, lines);
    }
    /// To be called with a line, as text and as a value, before what it says is acted upon.
    void hear(std::string_view text, const protocol::InfoLine& line);
    /// Lets the behavior answer to a line and sends what it says. An STA ends the tick, also without a behavior.
    void answer(const protocol::InfoLine& line);
    /// Sends the commands before processing the results, so that the simulator computes its next tick meanwhile. In the
    /// last tick it is the other way around: receivers of the end must find the simulator's time standing still.
    void takeOutput(agent::RunningBehavior::Output output, bool is_tick);
    /// True while a plan is halted and the server's time is stopped with it.
    bool timeIsHeld() const { return step_held_; }
    /// Releases waiting DRIVEs, because the clock may stand still; not in lockstep or while the owner is congested.
    void look();

    void sendForSession(const protocol::Command& command, const char* why);
    void sendForUser(const protocol::Command& command, const by::Source& source);
    /// Brings a robot to rest at once, with the behavior's safe command if there is one.
    void makeSafe(const by::Source& source);
    void stopBehavior(const by::Source& source, const std::string& reason);

    bool hasBehavior() const { return host_ != nullptr; }
    void start(std::shared_ptr<agent::RunningBehavior> host);
    void order(agent::Order order);
    void control(const agent::PlanControl& control);
    void setParameters(const agent::ParameterSet& parameters);
    /// Drops the behavior; returns true if it had failed by itself.
    bool dismiss();

    /// Refused with a notice while a plan is halted; the robot must have spawned.
    void takeControl();
    /// Ends control by hand, with a stop; does nothing without it.
    void endControl(const std::string& reason);
    void drive(const HandIntent& intent);
    /// Ends a hold with a stop, but not the control.
    void endHold(const std::string& reason);

private:
    bool halted() const { return host_ && host_->halted(); }
    void releaseDrives(bool at_once);
    void sendByHand(const HandCommands& hand, bool at_once);
    void beat();
    void tickHand();
    void endTick();
    void step();
    void stepOwed();
    void behaviorEnded();

    HelmOwner& owner_;
    HelmView view_;
    SessionLimits limits_;
    Outgoing outgoing_;
    HandDriver hand_;
    QTimer hand_timer_; ///< runs while an input device holds the robot
    std::shared_ptr<agent::RunningBehavior> host_;
    std::unique_ptr<QSocketNotifier> end_watch_; ///< for a behavior that may end between two calls
    std::uint64_t steps_sent_ = 0;
    bool lockstep_ = false;
    bool step_held_ = false; ///< a STEP is owed, because a plan is halted
};

} // namespace usar::mission
