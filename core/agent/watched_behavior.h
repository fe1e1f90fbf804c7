// A behavior in a thread of its own, which is abandoned if it hangs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/agent/behavior_host.h"
#include "core/agent/remote_behavior.h"
#include "core/agent/shared_processor.h"

namespace usar::agent {

/// The owner's thread hands over one call at a time and waits for the answer; lines that it expects are handed over
/// together, and the answers taken one by one. A call that is not answered within the patience is the last one: the
/// robot gets the safe command that the behavior gave after the previous call, and the thread is abandoned together
/// with everything that it may still access, because a thread cannot be ended from outside. The thread ends by itself
/// if the call ever returns.
class WatchedBehavior final : public RemoteBehavior {
public:
    /// Starts the thread, in which all calls of `host` are made.
    explicit WatchedBehavior(std::unique_ptr<BehaviorHost> host);
    ~WatchedBehavior() override;

    Output begin() override;
    void expect(LineNumber first, std::span<const std::string_view> lines) override;
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
    LineNumber next_expected_;       ///< the line that is to be received next, of those that were handed over
    LineNumber end_of_expected_;
    std::uint64_t calls_before_ = 0;           ///< asked before those lines
    std::optional<SharedProcessor> processor_; ///< It serves both threads and ends before them.
};

} // namespace usar::agent
