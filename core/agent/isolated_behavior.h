// A behavior in a process of its own: what it breaks there breaks nothing here.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QString>

#include "core/agent/behavior_frames.h"
#include "core/agent/host_process.h"
#include "core/agent/running_behavior.h"

namespace usar::agent {

/// Starts usar-behavior-host and asks it as it would ask a BehaviorHost: each call crosses to the other process and
/// waits for its answer there, so that a mission is the same either way. One that is gone (its process, or its end of
/// the connection) or does not answer within the patience (it is killed then) gives the safe command that it named
/// last, and BehaviorFinished says by which signal it died, in which state and at which line. Ends its process when it
/// goes.
class IsolatedBehavior final : public RunningBehavior {
public:
    /// `program` is the path of usar-behavior-host. Nothing is started before `begin`.
    IsolatedBehavior(QString program, frames::Start start);
    ~IsolatedBehavior() override;

    Output begin() override;
    Output receive(const protocol::InfoLine& line) override;
    Output order(Order order) override;
    Output control(const PlanControl& control) override;
    void setParameters(const ParameterSet& parameters) override;
    CausedCommand safeCommand(const std::string& source) const override;
    bool halted() const override { return halted_; }
    bool finished() const override { return finished_; }
    bool ending() const override { return ending_; }
    bool broke() const override { return broke_; }
    const std::string& behaviorId() const override { return start_.behavior_id; }
    void setPatience(Seconds patience) override { patience_ = patience; }
    int endHandle() const override { return host_ ? host_->endHandle() : -1; }
    Output takeEnd() override;

    /// 0 where there is none, or none any more.
    int processId() const { return host_ ? host_->id() : 0; }

private:
    /// `at_work` says what it does meanwhile: "it worked on line 7 (STA …)".
    Output ask(const frames::Request& request, Seconds patience, const std::string& at_work);
    Output take(frames::Answer& answer);
    /// It is gone: the robot first, the reason by `takeEnd`.
    Output lose(const std::string& at_work);
    Output die(const std::string& how, const std::string& at_work);
    Output end(const std::string& reason);

    QString program_;
    frames::Start start_;
    std::unique_ptr<HostProcess> host_;
    protocol::Command safe_;
    LineNumber last_line_;
    std::string last_text_;     ///< of that line, shortened
    std::string last_state_;    ///< that it has told
    std::string last_decision_; ///< state or plan node that caused its newest command
    std::string lost_at_work_;  ///< what it did when it was lost; for `takeEnd`
    Output owed_;               ///< came of a call that answers nothing
    Seconds patience_{1.0};
    bool halted_ = false;
    bool ending_ = false;
    bool finished_ = false;
    bool broke_ = false;
};

} // namespace usar::agent
