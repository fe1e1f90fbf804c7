// Holds a running plan still where a person wants it, and pretends what they want: breakpoints, steps, pins, drives
// off.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/plan_control.h"
#include "core/agent/published.h"
#include "core/posh/engine.h"
#include "core/posh/pinned_host.h"

namespace usar::agent {

/// Stands between one engine and its host, and watches its run. Whoever runs the cycles asks it after each whether to
/// stand still, and runs none while it does. On the engine's thread.
class PoshDebugger {
public:
    /// `host` must outlive it.
    explicit PoshDebugger(posh::Host& host) : pins_(host) {}

    posh::Host& host() { return pins_; }
    posh::TraceObserver& observer() { return breakpoints_; }

    /// What could not be set, a sentence each.
    std::vector<std::string> set(const SetBreakpoints& all);
    void set(const SetPins& pins, posh::Engine& engine);
    /// Another program runs: it knows nothing of what was switched off.
    void switchDrives(posh::Engine& engine) const;

    /// Behind the next cycle, whatever happens in it.
    void haltSoon(bool as_step) { soon_ = as_step ? Soon::Step : Soon::Halt; }
    bool halted() const { return halted_; }
    /// The plan may go on.
    void release() { halted_ = false; }
    /// After each cycle: why it stands still now, if it does.
    std::optional<PlanHalted> afterCycle(const posh::Engine& engine, Seconds now);
    /// An act was answered for in place of the robot since the last call.
    bool takeActed() { return pins_.takeActed(); }

private:
    enum class Soon { No, Halt, Step };
    struct Known {
        PlanBreakpoint asked;
        std::size_t number = 0; ///< in breakpoints_
    };
    PlanHalted describe(const posh::BreakHit& hit, const posh::Program& program) const;

    posh::PinnedHost pins_;
    posh::Breakpoints breakpoints_;
    std::map<int, Known> known_; ///< by id
    std::vector<DriveOff> drives_off_;
    Soon soon_ = Soon::No;
    bool halted_ = false;
};

} // namespace usar::agent
