// The interface through which a plan uses its robot: senses and acts.
#pragma once

#include <string_view>

#include "core/posh/run/program.h"

namespace usar::posh {

/// The result of running an act. Finished: complete without taking time, so the cycle continues. RunningOnce: complete
/// after this cycle. Running: needs more cycles. Failed: cannot be done.
enum class ActResult : std::uint8_t { Finished, RunningOnce, Running, Failed };

/// The reason why an act ended. Stopped: the engine was stopped or its program was replaced. Goal: the goal of the
/// collection was reached.
enum class DoneReason : std::uint8_t { Finished, Failed, Interrupted, Goal, Stopped };

/// A call of the program, and the place in the plan from which it is made.
struct CallSite {
    Index call = 0;  ///< index in Program::sense_calls or Program::act_calls
    Index place = 0; ///< index in Program::places
};

/// Implemented by the owner of the senses and acts. Exceptions are caught: a sense that throws does not hold, and an
/// act that throws in init or run has failed. All functions are called in the engine's thread, during a call of the
/// engine.
class Host {
public:
    virtual ~Host() = default;
    /// These return whether the host has a sense or act of that name. For names that it does not have, the engine uses
    /// its built-in ones (succeed, fail, doNothing).
    virtual bool hasSense(std::string_view name) const = 0;
    virtual bool hasAct(std::string_view name) const = 0;
    /// A program is loaded. All later call sites refer to this program, which exists at least until the next bind.
    virtual void bind(const Program& program) = 0;

    /// Evaluates a sense; called at most once per epoch for each call of the program. `answer` is nil at first. Must
    /// have no side effects.
    virtual void sense(CallSite site, Value& answer) = 0;
    /// Starts an act. Every init is followed by exactly one done; in between, run is called once per cycle.
    virtual void init(CallSite site) = 0;
    virtual ActResult run(CallSite site) = 0;
    virtual void done(CallSite site, DoneReason reason) = 0;
};

} // namespace usar::posh
