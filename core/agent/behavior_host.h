// Runs one behavior against the lines of one connection: the shape that a process boundary will have one day.
#pragma once

#include <memory>
#include <vector>

#include "core/agent/behavior.h"

namespace usar::agent {

/// Owns the behavior and its modules. Lines and orders go in, caused commands and published values come out. The
/// behavior ticks on every STA (thesis 3). A behavior that throws is stopped: its safe command is sent and
/// BehaviorFinished says what was thrown. Used from its owner's thread.
class BehaviorHost {
public:
    struct Output {
        std::vector<CausedCommand> commands;
        std::vector<Published> published;
    };

    explicit BehaviorHost(std::unique_ptr<Behavior> behavior, std::string behavior_id);
    ~BehaviorHost();

    Output receive(const protocol::InfoLine& line);
    Output order(Order order);
    void setParameters(const ParameterSet& parameters);
    /// The safe command, with `source` as its cause.
    CausedCommand safeCommand(const std::string& source) const;
    bool finished() const { return finished_; }

private:
    Output answers(LineNumber trigger, auto&& call);

    std::unique_ptr<Behavior> behavior_;
    std::string behavior_id_;
    modules::RobotModules modules_;
    CommandPort port_;
    bool finished_ = false;
};

} // namespace usar::agent
