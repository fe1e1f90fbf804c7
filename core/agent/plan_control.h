// What a person asks of a behavior that a plan decides: another plan, where to stop, what to pretend, and how to go on.
// Values only: they cross threads and, one day, processes.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/posh/breakpoints.h"
#include "core/posh/host.h"

namespace usar::agent {

/// A POSH plan as a person wrote it.
struct PlanText {
    std::string name; ///< of the file, for messages
    std::string text;
    bool operator==(const PlanText&) const = default;
};

/// Between two cycles this plan takes the place of the one that runs. PlanReplaced says what became of it.
struct ReplacePlan {
    PlanText plan;
    bool operator==(const ReplacePlan&) const = default;
};

/// `id` is the asker's: what is said of a breakpoint names it by that.
struct PlanBreakpoint {
    int id = 0;
    posh::Breakpoint what;
    bool operator==(const PlanBreakpoint&) const = default;
};

/// All that there are from now on. Those that were there already keep their counts of hits.
struct SetBreakpoints {
    std::vector<PlanBreakpoint> breakpoints;
    bool operator==(const SetBreakpoints&) const = default;
};

/// Calls are named as traces write them: fly("lake", $speed=9).
struct SensePin {
    std::string call;
    posh::Value answer;
    bool operator==(const SensePin&) const = default;
};
struct ActPin {
    std::string call;
    posh::ActResult result = posh::ActResult::Failed;
    bool operator==(const ActPin&) const = default;
};

/// Found as breakpoints are: by path, repaired by names.
struct DriveOff {
    std::string path;
    std::string names;
    bool operator==(const DriveOff&) const = default;
};

/// All that is pretended from now on; empty: nothing. They outlive a replaced plan.
struct SetPins {
    std::vector<SensePin> senses;
    std::vector<ActPin> acts;
    std::vector<DriveOff> drives_off;
    bool empty() const { return senses.empty() && acts.empty() && drives_off.empty(); }
    bool operator==(const SetPins&) const = default;
};

enum class PlanStep {
    Halt,     ///< stand still behind the next cycle
    Continue, ///< until a breakpoint hits
    Cycle,    ///< one, then stand still again
};

using PlanControl = std::variant<ReplacePlan, SetBreakpoints, SetPins, PlanStep>;

} // namespace usar::agent
