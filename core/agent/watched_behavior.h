// A behavior in a thread of its own, which is abandoned if it hangs.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/agent/behavior_host.h"
#include "core/agent/remote_behavior.h"

namespace usar::agent {

/// The owner's thread hands over one call at a time and waits for the answer. A call that is not answered within the
/// patience is the last one: the robot gets the safe command that the behavior gave after the previous call, and the
/// thread is abandoned together with everything that it may still access, because a thread cannot be ended from
/// outside. The thread ends by itself if the call ever returns.
class WatchedBehavior final : public RemoteBehavior {
public:
    /// Starts the thread, in which all calls of `host` are made.
    explicit WatchedBehavior(std::unique_ptr<BehaviorHost> host);
    ~WatchedBehavior() override;

    Output begin() override;
    Output receive(const protocol::InfoLine& line) override;
    Output order(Order order) override;
    Output control(const PlanControl& control) override;
    void setParameters(const ParameterSet& parameters) override;

private:
    struct Worker;
    /// Runs a call in the thread. `what` names the call for messages to the operator.
    Output run(std::function<Output(BehaviorHost&)> call, const std::string& what);
    /// Abandons the thread and reports that the behavior hangs.
    Output giveUp(const std::string& what);

    std::shared_ptr<Worker> worker_; ///< also owned by its thread
};

} // namespace usar::agent
