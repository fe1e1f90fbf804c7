// The trace of an engine: records of fixed size, in the order in which they happen.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "core/posh/run/host.h"
#include "core/posh/run/program.h"

namespace usar::posh {

/// The events of a run, with the fields of TraceRecord that they use besides `place`. Trace files store the numbers.
enum class TraceEvent : std::uint8_t {
    CycleBegin,
    CycleEnd,     ///< detail: outcome; place: number of acts run; payload: nanoseconds, 0 without a clock
    SenseEval,    ///< value, payload and text: the answer; flags: trace_holds, trace_cached
    DriveSkipped, ///< detail: skip reason; payload: milliseconds (or cycles) left, as a double
    DriveStarted,
    DriveSucceeded,
    DriveFailed,
    DriveInterrupted, ///< payload: place of the drive that won, or nowhere; flags: trace_adopt_kept
    Push,             ///< a form is entered
    Pop,              ///< a form is left
    ElementSelected,  ///< payload: starts in this engagement
    ElementSkipped,   ///< its retries are used up; payload: starts in this engagement
    NoElement,        ///< no element of a competence is ready
    Goal,             ///< the goal of a form holds
    Timeout,          ///< the time limit of a form is exceeded
    AdoptRetry,       ///< what an adopt does has failed; it will be tried again
    ActInit,
    ActRun,     ///< detail: result; payload: nanoseconds, 0 without a clock
    ActDone,    ///< detail: reason
    Blackboard, ///< text: "key: old -> new"
    Command,    ///< text: the message sent to the robot
    Warning,    ///< detail: warning code; text: the warning
    Error,      ///< text: what() of the exception that the host threw
};

/// The outcome of a cycle. Fired: an act ran. NoAction: a drive won but ran no act. Idle: no drive was ready. Budget:
/// the budget of acts was used up. GoalSatisfied: the goal of the collection holds. Won: the plan ended in an earlier
/// cycle.
enum class Outcome : std::uint8_t { Fired, NoAction, Idle, Budget, GoalSatisfied, Won };
/// The reason why a drive was passed over: it ran too recently for its frequency, or it is switched off.
enum class SkipReason : std::uint8_t { Frequency, SwitchedOff };
/// The kinds of warnings of an engine; the text of the record says the rest.
enum class WarningCode : std::uint8_t { Budget, UnlikeTypes, StarvingDrive, SlowPrimitive, Host };
/// The type of an answer; the order is that of the alternatives of Value.
enum class ValueKind : std::uint8_t { Nil, Boolean, Integer, Real, Text, Symbol };

constexpr std::uint8_t trace_holds = 1;      ///< the sense holds, after the comparison
constexpr std::uint8_t trace_cached = 2;     ///< the answer is from earlier in the same epoch
constexpr std::uint8_t trace_adopt_kept = 4; ///< the interrupted drive stays in progress in an adopt

/// One event. Numbers are stored in `payload` (see payloadOf); texts are passed separately.
struct TraceRecord {
    std::uint64_t cycle = 0;  ///< number of the cycle, counting from 1
    std::int64_t time_ms = 0; ///< the time that was passed to Engine::cycle
    std::uint64_t payload = 0;
    Index place = 0; ///< index in Program::places, except for CycleEnd
    TraceEvent event = TraceEvent::CycleBegin;
    std::uint8_t detail = 0; ///< read it with one of the functions below, depending on the event
    std::uint8_t flags = 0;
    ValueKind value = ValueKind::Nil; ///< type of the answer, for SenseEval

    /// For CycleEnd.
    Outcome outcome() const { return static_cast<Outcome>(detail); }
    /// For ActRun.
    ActResult result() const { return static_cast<ActResult>(detail); }
    /// For ActDone.
    DoneReason reason() const { return static_cast<DoneReason>(detail); }
    /// For DriveSkipped.
    SkipReason skip() const { return static_cast<SkipReason>(detail); }
    /// For Warning.
    WarningCode warning() const { return static_cast<WarningCode>(detail); }
    bool operator==(const TraceRecord&) const = default;
};
static_assert(sizeof(TraceRecord) == 32);

/// Type of a value, by the alternative that it holds.
inline ValueKind kindOf(const Value& value) {
    return static_cast<ValueKind>(value.index());
}

/// The bits of a number.
inline std::uint64_t payloadOf(double number) {
    return std::bit_cast<std::uint64_t>(number);
}

/// Returns the bits of a number or a boolean; 0 for nil and texts.
inline std::uint64_t payloadOf(const Value& value) {
    if (const auto* const number = std::get_if<double>(&value))
        return payloadOf(*number);
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
        return static_cast<std::uint64_t>(*whole);
    const auto* const flag = std::get_if<bool>(&value);
    return flag && *flag ? 1 : 0;
}

/// Returns the text of a string or a symbol; empty for other values.
inline std::string_view textOf(const Value& value) {
    if (const auto* const text = std::get_if<std::string>(&value))
        return *text;
    const auto* const symbol = std::get_if<Symbol>(&value);
    return symbol ? std::string_view(symbol->text) : std::string_view();
}

/// Returns the word used in traces, reports and files: "RunningOnce".
std::string_view toText(ActResult result);

/// Returns the answer of a SenseEval, from its record and text.
Value answerOf(const TraceRecord& record, std::string_view text);

/// Receives the trace of an engine. The functions are called in the engine's thread during its cycles; they must be
/// quick and must not call the engine.
class TraceObserver {
public:
    virtual ~TraceObserver() = default;
    /// A program is loaded. The places of all later records refer to it.
    virtual void takeProgram(const std::shared_ptr<const Program>& program) = 0;
    /// An event. `text` is valid during the call only: an answer that is a text, or the text of the event; often empty.
    virtual void take(const TraceRecord& record, std::string_view text) = 0;
};

/// A clock for measuring durations and finding slow senses and acts. The engine makes no decisions by it.
class ProfileClock {
public:
    virtual ~ProfileClock() = default;
    /// Returns the time since an arbitrary moment; it never runs backward.
    virtual std::int64_t nanoseconds() = 0;
};

} // namespace usar::posh
