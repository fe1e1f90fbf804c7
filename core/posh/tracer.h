// Stamps events with cycle and time and hands them to the observer, if there is one: one branch where there is none.
#pragma once

#include <chrono>
#include <memory>
#include <string_view>

#include "core/posh/trace_event.h"

namespace usar::posh {

using Milliseconds = std::chrono::milliseconds;

class Tracer {
public:
    bool watched() const { return observer_ != nullptr; }
    void watch(TraceObserver* observer, const std::shared_ptr<const Program>& program) {
        observer_ = observer;
        announce(program);
    }
    void announce(const std::shared_ptr<const Program>& program) const {
        if (observer_)
            observer_->takeProgram(program);
    }
    void setCycle(std::uint64_t cycle, Milliseconds now) {
        cycle_ = cycle;
        now_ = now;
    }
    std::uint64_t cycle() const { return cycle_; }
    Milliseconds now() const { return now_; }

    void note(TraceEvent event, Index place, std::uint64_t payload = 0, std::uint8_t detail = 0,
              std::uint8_t flags = 0) const {
        if (observer_)
            observer_->take({cycle_, now_.count(), payload, place, event, detail, flags, ValueKind::Nil}, {});
    }
    void noteText(TraceEvent event, Index place, std::string_view text, std::uint8_t detail = 0) const {
        if (observer_)
            observer_->take({cycle_, now_.count(), 0, place, event, detail, 0, ValueKind::Nil}, text);
    }
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
    TraceObserver* observer_ = nullptr;
    std::uint64_t cycle_ = 0;
    Milliseconds now_{0};
};

} // namespace usar::posh
