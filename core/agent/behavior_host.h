// Runs one behavior on the lines of one connection, in the caller's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/running_behavior.h"

namespace usar::agent {

/// Owns the behavior and its modules. Takes lines and orders, and returns commands with their causes and published
/// values. The behavior ticks on every STA (thesis 3). On every line, the host sends the next question waiting in the
/// modules; unanswered ones are reported as BehaviorEvent. A behavior is stopped if it throws or if its robot lacks a
/// sensor that it needs.
class BehaviorHost final : public RunningBehavior {
public:
    /// `behavior_id` begins the source of every cause: "airrobot/cpp: scanning". `sensors_needed` are types on the
    /// wire. If needed sensors have not reported within three seconds of the first tick, the server is asked for their
    /// configurations; once all is settled, the behavior is stopped if there is none, or no answer, of any of them.
    explicit BehaviorHost(std::unique_ptr<Behavior> behavior, std::string behavior_id,
                          std::vector<std::string> sensors_needed = {});
    Output receive(const protocol::InfoLine& line) override;
    Output order(Order order) override;
    Output control(const PlanControl& control) override;
    void setParameters(const ParameterSet& parameters) override;
    CausedCommand safeCommand(const by::Source& source) const override;

private:
    /// Makes the call unless the behavior has finished, and stops the behavior if it throws.
    template <class Call>
    void guarded(Call&& call);
    /// Replaces the commands of this call by the safe command and reports BehaviorFinished.
    void fail(const std::string& reason, std::vector<std::string> sensors_missing = {});
    /// Does so because of `sensors_lacking_`, if nothing is open about the other needed sensors.
    void failForSensors();
    /// A needed sensor that has reported is no longer missed.
    void noteSensor(const protocol::InfoMessage& message);
    /// Queues questions about the missed sensors once they have been silent too long.
    void askForSensors();
    template <class Module>
    void ask(Module& module, const std::string& subject);
    /// Empties the port, completes the sources of the causes, and notes the end or halt of the behavior.
    Output takeOutput();

    std::unique_ptr<Behavior> behavior_;
    modules::RobotModules modules_;
    CommandPort port_;
    std::vector<std::string> sensors_missed_;  ///< needed types that have not reported yet
    std::vector<std::string> sensors_lacking_; ///< needed types that the server does not know
    std::optional<Seconds> first_tick_;
};

} // namespace usar::agent
