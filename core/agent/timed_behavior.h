// A behavior that works for a limited time, divided in two: a decider, which knows the robot, and the behavior that
// carries messages to and from it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/agent/parameter_table.h"
#include "core/agent/robot_plugin.h"
#include "core/agent/timed_run.h"

namespace usar::agent {

/// The common part of deciders: settings, run and events. `Settings` has a ParameterTable `parameters`. Owned by one
/// behavior or plan body.
template <class Settings>
class TimedDecider {
public:
    explicit TimedDecider(const BehaviorContext& context)
        : settings_(Settings::parameters.settings(context.parameters)) {}

    /// Always true: the order was handled.
    bool order(Order order) { return run_.order(order); }
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
    explicit TimedBehavior(const BehaviorContext& context) : decider_(context) {}

    void onInfo(const protocol::InfoLine& line, CommandPort&) override { decider_.hear(line); }
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
