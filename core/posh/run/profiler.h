// Makes the calls of the host: catches their exceptions, measures how long they take and warns of slow ones.
#pragma once

#include <exception>

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

    /// Makes one call of the host for a place of the plan. Traces an exception as an error and a slow call as a
    /// warning; returns false after an exception.
    template <class Call>
    bool call(Index place, Call&& call) const {
        const std::int64_t begin_ns = now();
        bool good = false;
        try {
            call();
            good = true;
        } catch (const std::exception& thrown) {
            tracer_.noteText(TraceEvent::Error, place, thrown.what());
        } catch (...) {
            tracer_.noteText(TraceEvent::Error, place, "it threw something that is not a std::exception");
        }
        if (clock_ && now() - begin_ns > slow_ns_)
            tracer_.warn(WarningCode::SlowPrimitive, place, "slow: it took longer than its limit");
        return good;
    }

private:
    const Tracer& tracer_;
    ProfileClock* clock_;
    std::int64_t slow_ns_;
};

} // namespace usar::posh
