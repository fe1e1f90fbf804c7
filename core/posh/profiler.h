// Times what the host does, where somebody measures, and warns of what is slow.
#pragma once

#include "core/posh/tracer.h"

namespace usar::posh {

class Profiler {
public:
    Profiler(const Tracer& tracer, ProfileClock* clock, Milliseconds slow)
        : tracer_(tracer)
        , clock_(clock)
        , slow_ns_(std::chrono::nanoseconds(slow).count()) {}

    std::int64_t now() const { return clock_ ? clock_->nanoseconds() : 0; }

    /// One call of the host, from making to destruction.
    class Span {
    public:
        Span(Profiler& profiler, Index place) : profiler_(profiler), place_(place), begin_ns_(profiler.now()) {}
        ~Span() {
            if (profiler_.clock_ && elapsed() > profiler_.slow_ns_)
                profiler_.tracer_.warn(WarningCode::SlowPrimitive, place_, "slow: it took longer than its limit");
        }
        Span(const Span&) = delete;
        Span& operator=(const Span&) = delete;
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
