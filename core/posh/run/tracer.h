// The program, the cycle and the time of a run, its trace, and its calls of the host.
#pragma once

#include <chrono>
#include <exception>
#include <memory>
#include <string_view>
#include <utility>

#include "core/posh/run/trace_event.h"

namespace usar::posh {

using Milliseconds = std::chrono::milliseconds;

/// Used by all parts of one engine, in its thread. Adds cycle and time to events and passes them to the observer;
/// without one, an event costs only a branch. Places are indices in Program::places.
class Tracer {
public:
    explicit Tracer(std::shared_ptr<const Program> program) : program_(std::move(program)) {}

    /// The program that runs; never null.
    const std::shared_ptr<const Program>& program() const { return program_; }
    /// Sets another program, without announcing it, and returns the one before.
    std::shared_ptr<const Program> setProgram(std::shared_ptr<const Program> program) {
        return std::exchange(program_, std::move(program));
    }
    /// Returns whether there is an observer; check it before computing an expensive text.
    bool watched() const { return observer_ != nullptr; }
    /// Sets the observer, which must stay valid until it is replaced, and announces the program to it. nullptr removes
    /// it.
    void watch(TraceObserver* observer) {
        observer_ = observer;
        announce();
    }
    /// Tells the observer that another program is loaded.
    void announce() const {
        if (observer_)
            observer_->takeProgram(program_);
    }
    /// Sets the number and time of the cycle for the events that follow.
    void setCycle(std::uint64_t cycle, Milliseconds now) {
        cycle_ = cycle;
        now_ = now;
    }
    std::uint64_t cycle() const { return cycle_; }
    Milliseconds now() const { return now_; }

    /// Traces an event; see TraceEvent for the meaning of payload, detail and flags.
    void note(TraceEvent event, Index place, std::uint64_t payload = 0, std::uint8_t detail = 0,
              std::uint8_t flags = 0) const {
        if (observer_)
            observer_->take({cycle_, now_.count(), payload, place, event, detail, flags, ValueKind::Nil}, {});
    }
    /// Traces an event with a text.
    void noteText(TraceEvent event, Index place, std::string_view text, std::uint8_t detail = 0) const {
        if (observer_)
            observer_->take({cycle_, now_.count(), 0, place, event, detail, 0, ValueKind::Nil}, text);
    }
    /// Traces an answer. `holds` is the verdict; `cached` means that the answer was already known in this epoch.
    void noteSense(Index place, const Value& answer, bool holds, bool cached) const {
        if (!observer_)
            return;
        const auto flags = static_cast<std::uint8_t>((holds ? trace_holds : 0) | (cached ? trace_cached : 0));
        observer_->take(
            {cycle_, now_.count(), payloadOf(answer), place, TraceEvent::SenseEval, 0, flags, kindOf(answer)},
            textOf(answer));
    }
    void warn(WarningCode code, Index place, std::string_view text) const {
        noteText(TraceEvent::Warning, place, text, static_cast<std::uint8_t>(code));
    }

private:
    std::shared_ptr<const Program> program_;
    TraceObserver* observer_ = nullptr;
    std::uint64_t cycle_ = 0;
    Milliseconds now_{0};
};

/// Makes the calls of the host: catches their exceptions, measures how long they take and warns of slow ones. Without a
/// clock nothing is measured and nothing is slow.
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
