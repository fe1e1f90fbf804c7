// A behavior that works for a limited time, divided in two: a decider, which knows the robot, and the behavior that
// carries messages to and from it; and their common state: clock, state in words, operator's orders, and end.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// For behaviors with simple orders: Pause stops the robot until Resume, and LandNow ends the behavior. Times are those
/// of the ticks, on the protocol's clock. One behavior owns it. It is plain data without a thread or a clock of its
/// own. Call `step` once per tick, before everything else, and check `ending` after it.
struct TimedRun {
    Seconds now{0.0};             ///< time of the newest tick
    std::optional<Seconds> began; ///< time of the first tick
    /// Set by orders; the behavior itself must stop the robot.
    bool paused = false;
    std::string state = "waiting";          ///< in words
    std::optional<BehaviorFinished> ending; ///< set when the behavior is to end

    /// Takes the time of a tick and returns the time since the last one; 0 at the first.
    Seconds step(Seconds tick) {
        const Seconds passed = began ? tick - now : Seconds{0.0};
        now = tick;
        if (!began)
            began = now;
        return passed;
    }
    /// Time since the first tick, including pauses; 0 before it.
    Seconds elapsed() const { return began ? now - *began : Seconds{0.0}; }
    /// True if the behavior has run for `whole` and nothing else has ended it; never true if `whole` is 0.
    bool isOver(Seconds whole) const { return whole > Seconds{0.0} && elapsed() >= whole && !ending; }
    /// Handles an order; returns true.
    bool order(Order order) {
        if (order == Order::LandNow)
            ending = {false, "A person asked the robot to stop."};
        else
            paused = order == Order::Pause;
        return true;
    }
    /// The status, with progress and remaining time if `whole` is not 0.
    BehaviorStatus status(Seconds whole, double way_m) const {
        BehaviorStatus status;
        status.time = now;
        status.elapsed = elapsed();
        status.state = state;
        status.distance_flown_m = way_m;
        status.paused = paused;
        if (whole > Seconds{0.0}) {
            status.progress_pct = std::min(100.0, 100.0 * (status.elapsed / whole));
            status.time_left = std::max(Seconds{0.0}, whole - status.elapsed);
        }
        return status;
    }
};

/// The common part of deciders: settings, run and events. `Settings` has a ParameterTable `parameters`. Owned by one
/// behavior or plan body.
template <class Settings>
class TimedDecider {
public:
    /// The parameters of the context must be those of the settings' table.
    explicit TimedDecider(const BehaviorContext& context)
        : settings_(Settings::parameters.settings(context.parameters)) {}

    /// Always true: the order was handled.
    bool order(Order order) { return run_.order(order); }
    /// Replaces all settings; they take effect at the next tick.
    void setParameters(const ParameterSet& parameters) { settings_ = Settings::parameters.settings(parameters); }
    const Settings& settings() const { return settings_; }
    /// The current activity, in words.
    const std::string& state() const { return run_.state; }
    /// How the behavior ended; nullopt while it runs.
    const std::optional<BehaviorFinished>& ending() const { return run_.ending; }
    /// Returns the events since the last call.
    std::vector<BehaviorEvent> takeEvents() { return std::exchange(events_, {}); }

protected:
    TimedRun run_;
    Settings settings_;
    std::vector<BehaviorEvent> events_;
};

/// Passes lines, orders and parameters to a `Decider`, which is a TimedDecider with `hear(line)` and `status()`. Derive
/// from it, and define `tick` and `safeCommand`.
template <class Decider>
class TimedBehavior : public Behavior {
public:
    /// The context is passed to the decider, which takes what it needs.
    explicit TimedBehavior(const BehaviorContext& context) : decider_(context) {}

    void onInfo(const protocol::InfoLine& line, CommandPort&) override { decider_.hear(line); }
    /// Passes an order on and, if it ends the behavior, sends the safe command at once.
    void order(Order order, CommandPort& port) override {
        decider_.order(order);
        if (decider_.ending())
            end(port);
    }
    void setParameters(const ParameterSet& parameters) override { decider_.setParameters(parameters); }

protected:
    /// Publishes events, pose and status of a tick. If the decider has ended, also stops the robot, publishes how it
    /// ended, and returns false: the tick must send nothing more.
    bool goesOn(const std::optional<PoseEstimate>& pose, CommandPort& port) {
        for (BehaviorEvent& event : decider_.takeEvents())
            port.publish(std::move(event));
        if (pose)
            port.publish(*pose);
        port.publish(decider_.status());
        if (decider_.ending())
            end(port);
        return !decider_.ending();
    }

    Decider decider_;

private:
    void end(CommandPort& port) {
        port.send(safeCommand(), "done");
        port.publish(*decider_.ending());
    }
};

} // namespace usar::agent
