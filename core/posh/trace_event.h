// What an engine tells of its run: records of one size, in the order of what happened.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "core/posh/host.h"
#include "core/posh/program.h"

namespace usar::posh {

enum class TraceEvent : std::uint8_t {
    CycleBegin,
    CycleEnd,     ///< detail: outcome; place: number of acts run; payload: nanoseconds, 0 where nobody measures
    SenseEval,    ///< value and payload: the answer; holds, cached
    DriveSkipped, ///< detail: skip reason; payload: milliseconds (or cycles) left, a double
    DriveStarted,
    DriveSucceeded,
    DriveFailed,
    DriveInterrupted, ///< payload: place of the drive that won, or nowhere; adopt_kept
    Push,
    Pop,
    ElementSelected, ///< payload: starts in this engagement
    ElementSkipped,  ///< its retries are used up; payload: starts
    NoElement,
    Goal,
    Timeout,
    AdoptRetry,
    ActInit,
    ActRun,     ///< detail: result; payload: nanoseconds, 0 where nobody measures
    ActDone,    ///< detail: reason
    Blackboard, ///< text: "key: old -> new"
    Command,    ///< text: what was sent to the robot
    Warning,    ///< detail: warning code; text
    Error,      ///< text: what was thrown
};

enum class Outcome : std::uint8_t { Fired, NoAction, Idle, Budget, GoalSatisfied, Won };
enum class SkipReason : std::uint8_t { Frequency, SwitchedOff };
enum class WarningCode : std::uint8_t { Budget, UnlikeTypes, StarvingDrive, SlowPrimitive, Host };
enum class ValueKind : std::uint8_t { Nil, Boolean, Integer, Real, Text, Symbol };

constexpr std::uint8_t trace_holds = 1;
constexpr std::uint8_t trace_cached = 2;
constexpr std::uint8_t trace_adopt_kept = 4;

/// Numbers are whole in `payload` (see payloadOf); texts travel beside the record.
struct TraceRecord {
    std::uint64_t cycle = 0;
    std::int64_t time_ms = 0; ///< as the host counts
    std::uint64_t payload = 0;
    Index place = 0;
    TraceEvent event = TraceEvent::CycleBegin;
    std::uint8_t detail = 0;
    std::uint8_t flags = 0;
    ValueKind value = ValueKind::Nil;

    Outcome outcome() const { return static_cast<Outcome>(detail); }
    ActResult result() const { return static_cast<ActResult>(detail); }
    DoneReason reason() const { return static_cast<DoneReason>(detail); }
    SkipReason skip() const { return static_cast<SkipReason>(detail); }
    WarningCode warning() const { return static_cast<WarningCode>(detail); }
    bool operator==(const TraceRecord&) const = default;
};
static_assert(sizeof(TraceRecord) == 32);

inline ValueKind kindOf(const Value& value) {
    return static_cast<ValueKind>(value.index());
}

inline std::uint64_t payloadOf(double number) {
    return std::bit_cast<std::uint64_t>(number);
}

/// The bits of a number or truth value; 0 for nil and texts.
inline std::uint64_t payloadOf(const Value& value) {
    if (const auto* const number = std::get_if<double>(&value))
        return payloadOf(*number);
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
        return static_cast<std::uint64_t>(*whole);
    const auto* const flag = std::get_if<bool>(&value);
    return flag && *flag ? 1 : 0;
}

inline std::string_view textOf(const Value& value) {
    if (const auto* const text = std::get_if<std::string>(&value))
        return *text;
    const auto* const symbol = std::get_if<Symbol>(&value);
    return symbol ? std::string_view(symbol->text) : std::string_view();
}

/// The answer of a SenseEval, from its record and the text beside it.
Value answerOf(const TraceRecord& record, std::string_view text);

/// Watches an engine. Called on its thread, in the middle of its cycles: must be quick and must not call it back.
class TraceObserver {
public:
    virtual ~TraceObserver() = default;
    /// Before the first record of a program; places of the records that follow are its.
    virtual void takeProgram(const std::shared_ptr<const Program>& program) = 0;
    /// `text` lives during the call: the answer of a sense that is a text, or what an event says.
    virtual void take(const TraceRecord& record, std::string_view text) = 0;
};

/// Measures time for durations and slow primitives; the engine never decides by it.
class ProfileClock {
public:
    virtual ~ProfileClock() = default;
    virtual std::int64_t nanoseconds() = 0;
};

} // namespace usar::posh
