// Runs one behavior against the lines of one connection: the shape that a process boundary will have one day.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/agent/behavior.h"

namespace usar::agent {

/// Owns the behavior and its modules. Lines and orders go in, caused commands and published values come out. The
/// behavior ticks on every STA (thesis 3); questions that the modules have waiting are sent on every line, and those
/// that nobody answers are reported as BehaviorEvent. A behavior that throws is stopped: its safe command is sent and
/// BehaviorFinished says what was thrown. A finished behavior is not called again. Used from its owner's thread.
class BehaviorHost {
public:
    struct Output {
        std::vector<CausedCommand> commands;
        std::vector<Published> published;
    };

    /// `behavior_id` begins the source of every cause: "airrobot/cpp: scanning".
    explicit BehaviorHost(std::unique_ptr<Behavior> behavior, std::string behavior_id);
    ~BehaviorHost();

    Output receive(const protocol::InfoLine& line);
    Output order(Order order);
    Output control(const PlanControl& control);
    /// Its plan stands still: time should, too.
    bool halted() const { return halted_; }
    /// What the behavior threw, if it did, comes out of the next call.
    void setParameters(const ParameterSet& parameters);
    /// The safe command, with `source` as its cause; a DRIVE of zeros, for a robot on the ground or in the air,
    /// where the behavior cannot even say that.
    CausedCommand safeCommand(const std::string& source) const;
    bool finished() const { return finished_; }
    const std::string& behaviorId() const { return behavior_id_; }

private:
    template <class Call>
    void guarded(Call&& call);
    void stopAfterThrow(const std::string& what);
    template <class Module>
    void ask(Module& module, const std::string& subject);
    void askQuestions();
    Output takeOutput();

    std::unique_ptr<Behavior> behavior_;
    std::string behavior_id_;
    modules::RobotModules modules_;
    CommandPort port_;
    LineNumber last_line_;
    bool finished_ = false;
    bool halted_ = false;
};

} // namespace usar::agent
