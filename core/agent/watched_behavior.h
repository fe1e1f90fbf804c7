// A behavior in a thread of its own, given up when it hangs.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/agent/behavior_host.h"

namespace usar::agent {

/// The owner hands over one call at a time and waits for the answer. A call that is not answered within the patience is
/// the last: the robot gets the safe command that the behavior gave after the call before, and its thread is left alone
/// with all that it may still touch, for no thread can be ended from outside. It ends by itself if the call ever does.
class WatchedBehavior final : public RunningBehavior {
public:
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
    /// `what` names the call for the person.
    Output run(std::function<Output(BehaviorHost&)> call, const std::string& what);
    Output giveUp(const std::string& what);

    std::shared_ptr<Worker> worker_; ///< its thread owns it, too
    std::string behavior_id_;
    protocol::Command safe_;
    LineNumber last_line_;
    Output owed_; ///< came of a call that answers nothing
    Seconds patience_{1.0};
    bool halted_ = false;
    bool finished_ = false;
    bool broke_ = false;
};

} // namespace usar::agent
