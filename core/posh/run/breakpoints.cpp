#include "core/posh/run/breakpoints.h"

#include <utility>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/comparison.h"
#include "core/posh/run/value_text.h"

namespace usar::posh {

namespace {

bool isBegin(TraceEvent event) {
    return event == TraceEvent::DriveStarted || event == TraceEvent::ElementSelected || event == TraceEvent::Push ||
           event == TraceEvent::ActInit || event == TraceEvent::SenseEval;
}

bool isEnd(TraceEvent event) {
    return event == TraceEvent::DriveSucceeded || event == TraceEvent::DriveFailed ||
           event == TraceEvent::DriveInterrupted || event == TraceEvent::Pop || event == TraceEvent::ActDone;
}

bool isInterruption(const TraceRecord& record) {
    return record.event == TraceEvent::DriveInterrupted ||
           (record.event == TraceEvent::ActDone && record.reason() == DoneReason::Interrupted);
}

} // namespace

Result<std::size_t> Breakpoints::add(Breakpoint breakpoint) {
    Watch watch;
    if (!breakpoint.condition.empty()) {
        auto condition = readCondition(breakpoint.condition);
        if (!condition)
            return tl::unexpected(condition.error());
        watch.condition = *std::move(condition);
    }
    watch.place = find(breakpoint);
    watches_.emplace(next_number_, std::move(watch));
    breakpoints_.emplace(next_number_, std::move(breakpoint));
    return next_number_++;
}

void Breakpoints::remove(std::size_t number) {
    breakpoints_.erase(number);
    watches_.erase(number);
}

/// Compiles the condition as the trigger of a plan that has nothing else in it.
Result<std::shared_ptr<const Program>> Breakpoints::readCondition(const std::string& text) {
    const PlanReading reading = readPlan("((DC condition (drives ((it (trigger (\n" + text + "\n)) doNothing)))))");
    const Collection* const collection = collectionOf(reading.plan);
    if (hasErrors(reading.findings) || !collection || collection->levels.size() != 1)
        return failure("it is not a list of senses", "the condition " + text,
                       "Write for example (distance 0.3 <) (bumped)");
    return compile(reading.plan);
}

Result<void> Breakpoints::checkCondition(const std::string& text) {
    if (text.empty())
        return {};
    return readCondition(text).map([](const auto&) {});
}

Index Breakpoints::find(const Breakpoint& breakpoint) const {
    return program_ ? findPlace(*program_, breakpoint.path, breakpoint.names) : nowhere;
}

void Breakpoints::takeProgram(const std::shared_ptr<const Program>& program) {
    program_ = program;
    answers_.clear();
    for (auto& [number, watch] : watches_) {
        Breakpoint& breakpoint = breakpoints_.at(number);
        watch.place = find(breakpoint);
        watch.verdict.reset();
        if (watch.place != nowhere)
            breakpoint.path = pathOf(*program_, watch.place);
    }
}

void Breakpoints::take(const TraceRecord& record, std::string_view text) {
    if (breakpoints_.empty() || record.event == TraceEvent::CycleEnd)
        return;
    if (record.event == TraceEvent::SenseEval)
        remember(callTextAt(*program_, record.place), answerOf(record, text));
    if (record.event == TraceEvent::Blackboard)
        if (const auto change = readBoardChange(text))
            remember(change->key, readValue(change->new_value).value_or(Value()));
    for (auto& [number, watch] : watches_) {
        Breakpoint& breakpoint = breakpoints_.at(number);
        if (!happens(breakpoint, watch, record, text) || !breakpoint.enabled || !conditionHolds(watch) ||
            watch.hits++ < breakpoint.skip)
            continue;
        hits_.push_back({number, record, std::string(text)});
        breakpoint.enabled = !breakpoint.once;
    }
}

bool Breakpoints::happens(const Breakpoint& breakpoint, Watch& watch, const TraceRecord& record,
                          std::string_view text) const {
    if (breakpoint.on == BreakOn::Written) {
        const auto change = record.event == TraceEvent::Blackboard ? readBoardChange(text) : std::nullopt;
        return change && change->key == breakpoint.key && watch.place != nowhere;
    }
    if (watch.place != record.place)
        return false;
    switch (breakpoint.on) {
    case BreakOn::Before:
        return isBegin(record.event);
    case BreakOn::After:
        return isEnd(record.event);
    case BreakOn::Result:
        return record.event == TraceEvent::ActRun && record.result() == breakpoint.result;
    case BreakOn::VerdictChange: {
        if (record.event != TraceEvent::SenseEval)
            return false;
        const bool holds = (record.flags & trace_holds) != 0;
        const auto before = std::exchange(watch.verdict, holds);
        return before && *before != holds;
    }
    default:
        break;
    }
    return isInterruption(record);
}

bool Breakpoints::conditionHolds(const Watch& watch) const {
    if (!watch.condition)
        return true;
    for (const ProgramTest& test : watch.condition->tests) {
        const auto answer = answers_.find(watch.condition->sense_calls[test.call].text);
        if (answer == answers_.end())
            return false;
        const bool holds = test.compares ? compare(answer->second, test.predicate, test.operand) == Comparison::Holds
                                         : truthOf(answer->second);
        if (!holds)
            return false;
    }
    return true;
}

void Breakpoints::remember(std::string_view call, Value answer) {
    const auto known = answers_.find(call);
    if (known != answers_.end())
        known->second = std::move(answer);
    else
        answers_.emplace(call, std::move(answer));
}

std::vector<BreakHit> Breakpoints::takeHits() {
    return std::exchange(hits_, {});
}

} // namespace usar::posh
