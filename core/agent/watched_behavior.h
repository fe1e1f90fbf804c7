// A behavior in a thread of its own, which is abandoned if it hangs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/agent/behavior_host.h"

namespace usar::agent {

/// The owner's thread hands over one call at a time and waits for the answer. A call that is not answered within the
/// patience is the last one: the robot gets the safe command that the behavior gave after the previous call, and the
/// thread is abandoned together with everything that it may still access, because a thread cannot be ended from
/// outside. The thread ends by itself if the call ever returns.
class WatchedBehavior final : public RunningBehavior {
public:
    /// Starts the thread, in which all calls of `host` are made.
    explicit WatchedBehavior(std::unique_ptr<BehaviorHost> host);
    ~WatchedBehavior() override;

    Output begin() override;
    Output receive(const protocol::InfoLine& line) override;
    Output order(Order order) override;
    Output control(const PlanControl& control) override;
    void setParameters(const ParameterSet& parameters) override;
    CausedCommand safeCommand(const std::string& source) const override;
    bool halted() const override { return halted_; }
    bool finished() const override { return finished_; }
    bool broke() const override { return broke_; }
    const std::string& behaviorId() const override { return behavior_id_; }
    void setPatience(Seconds patience) override { patience_ = patience; }

private:
    struct Worker;
    /// Runs a call in the thread. `what` names the call for messages to the operator.
    Output run(std::function<Output(BehaviorHost&)> call, const std::string& what);
    /// Abandons the thread and reports that the behavior hangs.
    Output giveUp(const std::string& what);

    std::shared_ptr<Worker> worker_; ///< also owned by its thread
    std::string behavior_id_;
    protocol::Command safe_;
    LineNumber last_line_;
    Output owed_; ///< output of a call that returns none, for the next call to return
    Seconds patience_{1.0};
    bool halted_ = false;
    bool finished_ = false;
    bool broke_ = false;
};

} // namespace usar::agent
