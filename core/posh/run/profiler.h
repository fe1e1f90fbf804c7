// Measures how long calls of the host take and warns of slow ones.
#pragma once

#include "core/posh/run/tracer.h"

namespace usar::posh {

/// Without a clock nothing is measured and nothing is slow.
class Profiler {
public:
    /// `tracer` and `clock` must outlive this object; `clock` may be nullptr. A call that takes longer than `slow`
    /// causes a warning.
    Profiler(const Tracer& tracer, ProfileClock* clock, Milliseconds slow)
        : tracer_(tracer)
        , clock_(clock)
        , slow_ns_(std::chrono::nanoseconds(slow).count()) {}

    /// The time in nanoseconds since an arbitrary moment; 0 without a clock.
    std::int64_t now() const { return clock_ ? clock_->nanoseconds() : 0; }

    /// Measures one call of the host, from construction to destruction. `place` is the place of the call in the plan.
    class Span {
    public:
        Span(Profiler& profiler, Index place) : profiler_(profiler), place_(place), begin_ns_(profiler.now()) {}
        ~Span() {
            if (profiler_.clock_ && elapsed() > profiler_.slow_ns_)
                profiler_.tracer_.warn(WarningCode::SlowPrimitive, place_, "slow: it took longer than its limit");
        }
        Span(const Span&) = delete;
        Span& operator=(const Span&) = delete;
        /// Nanoseconds since construction; 0 without a clock.
        std::int64_t elapsed() const { return profiler_.now() - begin_ns_; }

    private:
        Profiler& profiler_;
        Index place_;
        std::int64_t begin_ns_;
    };

private:
    const Tracer& tracer_;
    ProfileClock* clock_;
    std::int64_t slow_ns_;
};

} // namespace usar::posh
