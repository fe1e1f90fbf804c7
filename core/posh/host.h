// What a plan asks of the program it runs in: its senses and its acts.
#pragma once

#include <string_view>

#include "core/posh/program.h"

namespace usar::posh {

/// Finished: complete, took no time, the cycle goes on. RunningOnce: complete after this cycle. Running: needs more
/// cycles. Failed: cannot be done.
enum class ActResult : std::uint8_t { Finished, RunningOnce, Running, Failed };

/// Why an act is over. Stopped: by the host, or because the plan was replaced.
enum class DoneReason : std::uint8_t { Finished, Failed, Interrupted, Goal, Stopped };

/// A call of the program, and the place that it stands at.
struct CallSite {
    Index call = 0; ///< in sense_calls or act_calls
    Index place = 0;
};

/// Implemented by whoever owns senses and acts. What it throws is caught: a sense that throws does not hold, an act
/// that throws in init or run has failed. Called only inside calls of the engine, on its thread.
class Host {
public:
    virtual ~Host() = default;
    /// Whether the host has a sense or act of that name; the built-in ones (succeed, fail, doNothing) serve where it
    /// has not.
    virtual bool hasSense(std::string_view name) const = 0;
    virtual bool hasAct(std::string_view name) const = 0;
    /// A program is put in; the numbers of calls that follow are of this one, which lives until the next.
    virtual void bind(const Program& program) = 0;

    /// Asked at most once per epoch for one call. `answer` is nil at first; must have no effect.
    virtual void sense(CallSite site, Value& answer) = 0;
    /// Every init is followed by exactly one done; in between run is called once per cycle.
    virtual void init(CallSite site) = 0;
    virtual ActResult run(CallSite site) = 0;
    virtual void done(CallSite site, DoneReason reason) = 0;
};

} // namespace usar::posh
