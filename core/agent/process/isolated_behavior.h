// A behavior in a process of its own, where it cannot damage this program.
#pragma once

#include <memory>
#include <string>

#include <QString>

#include "core/agent/process/behavior_frames.h"
#include "core/agent/process/host_process.h"
#include "core/agent/remote_behavior.h"

namespace usar::agent {

/// Starts usar-behavior-host and forwards each call to the BehaviorHost there, waiting for the answer, so that a
/// mission runs the same as without isolation. If the process or its end of the connection is gone, or if it does not
/// answer within the patience (it is killed then), this returns the behavior's last safe command, and BehaviorFinished
/// tells by which signal it died, in which state and at which line. The destructor ends the process.
class IsolatedBehavior final : public RemoteBehavior {
public:
    /// `program` is the path of usar-behavior-host. `begin` starts the process.
    IsolatedBehavior(QString program, frames::Start start);

    Output begin() override;
    Output receive(const protocol::InfoLine& line) override;
    Output order(Order order) override;
    Output control(const PlanControl& control) override;
    void setParameters(const ParameterSet& parameters) override;
    bool ending() const override { return ending_; }
    int endHandle() const override { return host_ ? host_->endHandle() : -1; }
    Output takeEnd() override;

    /// 0 if the process has not started or is gone.
    int processId() const { return host_ ? host_->id() : 0; }

private:
    /// Sends a request and waits for the answer. `at_work` describes the work for an error message: "it worked on
    /// line".
    Output ask(const frames::Request& request, Seconds patience, const std::string& at_work);
    /// Notes the state and the decision in an answer, for `die`, and returns its output.
    Output note(frames::Answer& answer);
    /// Handles the loss of the process: ends the behavior if the last reply says by which signal; else returns the safe
    /// command now and leaves the reason to `takeEnd`.
    Output lose(const std::optional<frames::Reply>& reply, const std::string& at_work);
    /// Ends the behavior with a reason that includes its last line, state and decision.
    Output die(const std::string& how, const std::string& at_work);
    /// Ends the behavior with the safe command and the reason.
    Output end(const std::string& reason);

    QString program_;
    frames::Start start_;
    std::unique_ptr<HostProcess> host_;
    std::string last_text_;     ///< text of the last line, shortened
    std::string last_state_;    ///< newest state in a BehaviorStatus
    std::string last_decision_; ///< state or plan node that caused its newest command
    std::string lost_at_work_;  ///< its work when it was lost, for `takeEnd`
    bool ending_ = false;
};

} // namespace usar::agent
