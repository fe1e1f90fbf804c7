// Runs one behavior against the lines of one connection, in the caller's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/running_behavior.h"

namespace usar::agent {

/// Owns the behavior and its modules. Lines and orders go in, caused commands and published values come out. The
/// behavior ticks on every STA (thesis 3); questions that the modules have waiting are sent on every line, and those
/// that nobody answers are reported as BehaviorEvent. A behavior that throws, or whose robot has not the sensors that
/// it needs, is stopped.
class BehaviorHost final : public RunningBehavior {
public:
    /// `behavior_id` begins the source of every cause: "airrobot/cpp: scanning". A sensor that is needed (by its type)
    /// and has not spoken in the first three seconds is asked for; where the server says that there is none, the
    /// behavior is stopped.
    explicit BehaviorHost(std::unique_ptr<Behavior> behavior, std::string behavior_id,
                          std::vector<std::string> sensors_needed = {});
    ~BehaviorHost() override;

    Output receive(const protocol::InfoLine& line) override;
    Output order(Order order) override;
    Output control(const PlanControl& control) override;
    bool halted() const override { return halted_; }
    void setParameters(const ParameterSet& parameters) override;
    CausedCommand safeCommand(const std::string& source) const override;
    bool finished() const override { return finished_; }
    bool broke() const override { return broke_; }
    const std::string& behaviorId() const override { return behavior_id_; }

private:
    template <class Call>
    void guarded(Call&& call);
    void fail(const std::string& reason);
    void noteSensor(const protocol::InfoMessage& message);
    void askForSensors();
    template <class Module>
    void ask(Module& module, const std::string& subject);
    void askQuestions();
    Output takeOutput();

    std::unique_ptr<Behavior> behavior_;
    std::string behavior_id_;
    modules::RobotModules modules_;
    CommandPort port_;
    std::vector<std::string> sensors_missed_; ///< types that are needed and have not spoken
    std::optional<Seconds> first_tick_;
    LineNumber last_line_;
    bool finished_ = false;
    bool halted_ = false;
    bool broke_ = false;
};

} // namespace usar::agent
