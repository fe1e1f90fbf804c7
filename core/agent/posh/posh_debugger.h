// Halts a running plan at breakpoints and after steps, and simulates what the user asks for: pinned senses and acts,
// and switched-off drives.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/plan_control.h"
#include "core/agent/published.h"
#include "core/posh/run/engine.h"
#include "core/posh/run/pinned_host.h"

namespace usar::agent {

/// Sits between one engine and its host and observes the run. The code that runs the cycles calls `afterCycle` after
/// each one and runs none while `halted`. Used in the engine's thread.
class PoshDebugger {
public:
    /// `host` must outlive this object.
    explicit PoshDebugger(posh::Host& host) : pins_(host) {}

    /// The host to give to the engine.
    posh::Host& host() { return pins_; }
    /// The observer that must get the engine's trace.
    posh::TraceObserver& observer() { return breakpoints_; }

    /// Replaces the breakpoints. Returns a sentence for each one that could not be set.
    std::vector<std::string> set(const SetBreakpoints& all);
    /// Replaces the pins and switches the drives of the engine on or off accordingly.
    void set(const SetPins& pins, posh::Engine& engine);
    /// Switches drives off again after the engine has got another program.
    void switchDrives(posh::Engine& engine) const;

    /// Requests a halt after the next cycle, whatever happens in it. `as_step` selects the reason that is reported.
    void haltSoon(bool as_step) { soon_ = as_step ? Soon::Step : Soon::Halt; }
    bool halted() const { return halted_; }
    /// Lets the plan continue.
    void release() { halted_ = false; }
    /// Call it after each cycle. Returns the reason if the plan halts now; `now` is the time of the cycle.
    std::optional<PlanHalted> afterCycle(const posh::Engine& engine, Seconds now);
    /// True if a pinned act was answered in place of the robot since the last call.
    bool takeActed() { return pins_.takeActed(); }

private:
    /// The reason for a halt after the next cycle, if one is requested.
    enum class Soon { No, Halt, Step };
    struct Known {
        PlanBreakpoint asked;
        std::size_t number = 0; ///< its key in breakpoints_
    };
    PlanHalted describe(const posh::BreakHit& hit, const posh::Program& program) const;

    posh::PinnedHost pins_;
    posh::Breakpoints breakpoints_;
    std::map<BreakpointId, Known> known_;
    std::vector<DriveOff> drives_off_;
    Soon soon_ = Soon::No;
    bool halted_ = false;
};

} // namespace usar::agent
