// A running behavior, wherever it runs: in the caller's thread, in a thread or in a process of its own.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/agent/behavior.h"

namespace usar::agent {

/// Takes lines and orders, and returns commands with their causes and published values. Each call waits for the answer,
/// so that a mission is the same wherever its behavior runs. A behavior that fails, hangs or dies returns its safe
/// command and BehaviorFinished with the reason, and is not called again; if finding the reason takes time, `ending` is
/// true before that. Used from its owner's thread.
class RunningBehavior {
public:
    /// The output of one call.
    struct Output {
        std::vector<CausedCommand> commands;
        std::vector<Published> published;

        void append(Output later) {
            std::ranges::move(later.commands, std::back_inserter(commands));
            std::ranges::move(later.published, std::back_inserter(published));
        }
    };

    virtual ~RunningBehavior() = default;

    /// Call it once before the first line. Does what takes time, such as starting a process.
    virtual Output begin() { return {}; }
    /// The next calls of `receive` will be for these lines, of which the first has this number, unless an end comes
    /// before: a behavior that thinks elsewhere may begin at once. An order that comes in between reaches it after all
    /// of them.
    virtual void expect(LineNumber, std::span<const std::string_view>) {}
    /// Takes one info line; call it for every line of the connection.
    virtual Output receive(const protocol::InfoLine& line) = 0;
    virtual Output order(Order order) = 0;
    virtual Output control(const PlanControl& control) = 0;
    /// The next call returns the output, such as the report of a failure.
    virtual void setParameters(const ParameterSet& parameters) = 0;
    /// The command that makes the robot safe, with `source` as its cause. Never waits for the behavior.
    virtual CausedCommand safeCommand(const by::Source& source) const = 0;

    /// True if its plan is halted; simulated time should stand still, too.
    bool halted() const { return halted_; }
    bool finished() const { return finished_; }
    /// True if it is gone for a reason not known yet: make the robot safe now, and then call `takeEnd`, which may take
    /// half a second to find the reason.
    virtual bool ending() const { return false; }
    /// True if it ended because of a fault (it threw, hung or died) and not by its own BehaviorFinished.
    bool broke() const { return broke_; }
    const std::string& behaviorId() const { return behavior_id_; }

    /// Sets how long an answer may take, in wall time, before the behavior counts as hanging. Call it before `begin`.
    virtual void setPatience(Seconds) {}
    /// A file descriptor that becomes readable if the behavior ends between two calls; then call `takeEnd`. Negative if
    /// it can end during calls only.
    virtual int endHandle() const { return -1; }
    /// The output of its end, including BehaviorFinished; empty if it has not ended.
    virtual Output takeEnd() { return {}; }

protected:
    explicit RunningBehavior(std::string behavior_id) : behavior_id_(std::move(behavior_id)) {}

    std::string behavior_id_;
    LineNumber last_line_; ///< number of the last info line that it got
    bool halted_ = false;
    bool finished_ = false;
    bool broke_ = false;
};

/// A DRIVE of zeros for a robot on the ground, in the water or (the default) in the air, for use if the behavior cannot
/// give its safe command.
protocol::Command lastResort(protocol::VehicleKind kind);

} // namespace usar::agent
