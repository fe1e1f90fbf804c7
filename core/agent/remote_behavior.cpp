#include "core/agent/remote_behavior.h"

#include <utility>

namespace usar::agent {

BehaviorAnswer answerOf(RunningBehavior::Output output, const RunningBehavior& behavior) {
    return {std::move(output), behavior.safeCommand({}).command, behavior.halted(), behavior.finished(),
            behavior.broke()};
}

RemoteBehavior::RemoteBehavior(std::string behavior_id)
    : behavior_id_(std::move(behavior_id))
    , safe_(lastResort(protocol::VehicleKind::Unknown)) {}

RunningBehavior::Output RemoteBehavior::take(BehaviorAnswer answer) {
    halted_ = answer.halted;
    finished_ = answer.finished;
    broke_ = answer.broke;
    safe_ = std::move(answer.safe);
    owed_.append(std::move(answer.output));
    return std::exchange(owed_, {});
}

RunningBehavior::Output RemoteBehavior::finish(const std::string& state, std::string reason) {
    finished_ = true;
    halted_ = false;
    owed_.commands = {safeCommand(by::Behavior{behavior_id_, state})};
    owed_.published.push_back(BehaviorFinished{false, std::move(reason)});
    return std::exchange(owed_, {});
}

} // namespace usar::agent
