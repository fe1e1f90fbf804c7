// The one act that an engine runs at a time: init once, run once per cycle or more, done exactly once.
#pragma once

#include <vector>

#include "core/posh/profiler.h"
#include "core/posh/tracer.h"

namespace usar::posh {

class CurrentAct {
public:
    CurrentAct(Host& host, const Tracer& tracer, Profiler& profiler)
        : host_(host)
        , tracer_(tracer)
        , profiler_(profiler) {}

    /// There must be no act.
    void load(const Program& program);
    /// Keeps what it knows; the program has the same shape.
    void retune(const Program& program) { program_ = &program; }

    /// In `acts`; nowhere for none.
    Index index() const { return act_; }
    bool ranIn(std::uint64_t cycle) const { return last_run_ == cycle; }

    /// Continues the act, or ends the one before (interrupted) and begins this. Unless the answer is Running, the act
    /// is over when this returns. What the host throws is a failure.
    ActResult run(Index act);
    /// Nothing without an act.
    void end(DoneReason reason);

private:
    ActResult begin(Index act);
    ActResult runOnce();
    template <class Call>
    bool guarded(Index place, Call&& call);

    Host& host_;
    const Tracer& tracer_;
    Profiler& profiler_;
    const Program* program_ = nullptr;
    std::vector<char> does_nothing_; ///< by act call: built in
    Index act_ = nowhere;
    std::uint64_t last_run_ = 0;
};

} // namespace usar::posh
