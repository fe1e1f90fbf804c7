// The act that an engine is running.
#pragma once

#include <vector>

#include "core/posh/run/tracer.h"

namespace usar::posh {

/// Runs at most one act at a time. For each act the host gets one init, then run at least once unless init throws, then
/// exactly one done. The built-in act `doNothing` never reaches the host, unless the host has an act of that name.
class CurrentAct {
public:
    /// All three must outlive this object.
    CurrentAct(Host& host, const Tracer& tracer, Profiler& profiler)
        : host_(host)
        , tracer_(tracer)
        , profiler_(profiler) {}

    /// Prepares for the tracer's program. No act may be current; call end first.
    void load();

    /// The current act as an index in Program::acts; `nowhere` if there is none.
    Index index() const { return act_; }
    /// Returns whether that is the last cycle in which an act was run.
    bool ranIn(std::uint64_t cycle) const { return last_run_ == cycle; }

    /// Continues the act if it is the current one; otherwise ends the current one as interrupted and begins this one.
    /// Unless the result is Running, the act has ended when this returns. An exception from the host counts as Failed.
    ActResult run(Index act);
    /// Ends the current act. Does nothing if there is none.
    void end(DoneReason reason);

private:
    ActResult begin(Index act);
    ActResult runOnce();
    const ProgramAct& actAt(Index index) const { return tracer_.program()->acts[index]; }

    Host& host_;
    const Tracer& tracer_;
    Profiler& profiler_;
    std::vector<char> does_nothing_; ///< for each act call: whether it is the built-in `doNothing`
    Index act_ = nowhere;
    std::uint64_t last_run_ = 0; ///< number of the cycle in which an act was last run
};

} // namespace usar::posh
