// The common part of behaviors that run elsewhere: in a thread or in a process of their own.
#pragma once

#include <string>

#include "core/agent/running_behavior.h"

namespace usar::agent {

/// The answer to one call of a behavior that runs elsewhere.
struct BehaviorAnswer {
    RunningBehavior::Output output; ///< empty for new parameters
    protocol::Command safe;         ///< the behavior's safe command at this time
    bool halted = false;            ///< as in RunningBehavior; so are the next two
    bool finished = false;
    bool broke = false;
};
/// The answer with this output; the rest is what the behavior says of itself now.
BehaviorAnswer answerOf(RunningBehavior::Output output, const RunningBehavior& behavior);

/// Keeps, in the owner's thread, what the behavior answered last, so that nothing here waits for it.
class RemoteBehavior : public RunningBehavior {
public:
    CausedCommand safeCommand(const by::Source& source) const override { return {safe_, {source, last_line_}}; }
    bool halted() const override { return halted_; }
    bool finished() const override { return finished_; }
    bool broke() const override { return broke_; }
    const std::string& behaviorId() const override { return behavior_id_; }
    void setPatience(Seconds patience) override { patience_ = patience; }

protected:
    explicit RemoteBehavior(std::string behavior_id);
    /// Takes over the state in an answer and returns its output, after the output owed from before.
    Output take(BehaviorAnswer answer);
    /// Marks the behavior as finished. Returns the published values owed from before, the safe command with `state` as
    /// its cause, and the reason.
    Output finish(const std::string& state, std::string reason);

    std::string behavior_id_;
    LineNumber last_line_; ///< number of the last info line that it got
    Output owed_;          ///< output of a call that returns none, for the next call to return
    Seconds patience_{1.0};
    protocol::Command safe_;
    bool halted_ = false;
    bool finished_ = false;
    bool broke_ = false;
};

} // namespace usar::agent
