// The common part of behaviors that run elsewhere: in a thread or in a process of their own.
#pragma once

#include <string>
#include <utility>

#include "core/agent/patience.h"
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
inline BehaviorAnswer answerOf(RunningBehavior::Output output, const RunningBehavior& behavior) {
    return {std::move(output), behavior.safeCommand({}).command, behavior.halted(), behavior.finished(),
            behavior.broke()};
}

/// Keeps, in the owner's thread, what the behavior answered last, so that nothing here waits for it.
class RemoteBehavior : public RunningBehavior {
public:
    /// The safe command of the last answer; it may be older than the robot's newest line.
    CausedCommand safeCommand(const by::Source& source) const override { return {safe_, {source, last_line_}}; }
    void setPatience(Seconds patience) override { patience_ = patience; }

protected:
    /// Until the first answer, the safe command is the last resort for an unknown vehicle.
    explicit RemoteBehavior(std::string behavior_id)
        : RunningBehavior(std::move(behavior_id))
        , safe_(lastResort(protocol::VehicleKind::Unknown)) {}
    /// Takes over the state in an answer and returns its output, after the output owed from before.
    Output take(BehaviorAnswer answer) {
        halted_ = answer.halted;
        finished_ = answer.finished;
        broke_ = answer.broke;
        safe_ = std::move(answer.safe);
        owed_.append(std::move(answer.output));
        return std::exchange(owed_, {});
    }
    /// Marks the behavior as finished. Returns the published values owed from before, the safe command with `state` as
    /// its cause, and the reason.
    Output finish(const std::string& state, std::string reason) {
        finished_ = true;
        halted_ = false;
        owed_.commands = {safeCommand(by::Behavior{behavior_id_, state})};
        owed_.published.push_back(BehaviorFinished{false, std::move(reason)});
        return std::exchange(owed_, {});
    }

    Output owed_; ///< output of a call that returns none, for the next call to return
    /// Time that one call of the behavior may take.
    Seconds patience_ = Patience().answer;
    /// The safe command in the last answer.
    protocol::Command safe_;
};

} // namespace usar::agent
