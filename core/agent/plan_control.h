// Requests to a behavior that is controlled by a plan: to replace the plan, to halt and continue it, and to simulate
// senses and acts. Plain data, which is passed between threads and processes.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/agent/published.h"
#include "core/posh/run/breakpoints.h"
#include "core/posh/run/host.h"

namespace usar::agent {

/// The source text of a POSH plan.
struct PlanText {
    std::string name; ///< file name, for messages
    std::string text;
    bool operator==(const PlanText&) const = default;
};

/// Replaces the running plan between two cycles. PlanReplaced reports the result.
struct ReplacePlan {
    PlanText plan;
    bool operator==(const ReplacePlan&) const = default;
};

/// A breakpoint. The sender chooses `id`, by which PlanHalted refers to it.
struct PlanBreakpoint {
    BreakpointId id;
    posh::Breakpoint what;
    bool operator==(const PlanBreakpoint&) const = default;
};

/// The complete list of breakpoints from now on. Breakpoints that were set before and have not changed keep their hit
/// counts.
struct SetBreakpoints {
    std::vector<PlanBreakpoint> breakpoints;
    bool operator==(const SetBreakpoints&) const = default;
};

/// Makes a sense answer with a fixed value. `call` is written as in traces: fly("lake", $speed=9).
struct SensePin {
    std::string call;
    posh::Value answer;
    bool operator==(const SensePin&) const = default;
};
/// Makes an act have a fixed result without reaching the robot.
struct ActPin {
    std::string call;
    posh::ActResult result = posh::ActResult::Failed;
    bool operator==(const ActPin&) const = default;
};

/// Switches a drive off. The drive is found by its path or, if the plan has changed, by its names, like a breakpoint.
struct DriveOff {
    std::string path;
    std::string names;
    bool operator==(const DriveOff&) const = default;
};

/// All pins and switched-off drives from now on; empty removes them. They remain in force if the plan is replaced.
struct SetPins {
    std::vector<SensePin> senses;
    std::vector<ActPin> acts;
    std::vector<DriveOff> drives_off;
    bool empty() const { return senses.empty() && acts.empty() && drives_off.empty(); }
    bool operator==(const SetPins&) const = default;
};

/// Halts or continues the plan.
enum class PlanStep {
    Halt,     ///< halt after the next cycle
    Continue, ///< until a breakpoint hits
    Cycle,    ///< run one cycle, then halt again
};

/// Any of these requests. They take effect between two cycles, also while the plan is halted.
using PlanControl = std::variant<ReplacePlan, SetBreakpoints, SetPins, PlanStep>;

} // namespace usar::agent
