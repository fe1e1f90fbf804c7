#include "core/posh/trace/trace_text.h"

#include <array>

#include "core/posh/run/value_text.h"

namespace usar::posh {

namespace {

/// The format of an event's line: a word, the path of the place, then the item given by `Tail`.
enum class Tail { Nothing, Name, Call, Text };
struct Wording {
    std::string_view word;
    Tail tail = Tail::Nothing;
    bool plain = true; ///< whether TraceDetail::Plain includes the event
};

/// Indexed by event, from SenseEval to Error.
constexpr std::array<Wording, 21> wordings{{
    {"sense", Tail::Call},          {"skip", Tail::Nothing},
    {"start", Tail::Name},          {"succeeded", Tail::Name},
    {"failed", Tail::Name},         {"interrupt", Tail::Name},
    {"push", Tail::Name, false},    {"pop", Tail::Name, false},
    {"select", Tail::Name},         {"skip", Tail::Nothing},
    {"noelement", Tail::Name},      {"goal", Tail::Name},
    {"timeout", Tail::Name},        {"retry", Tail::Name},
    {"init", Tail::Call},           {"run", Tail::Call},
    {"done", Tail::Call},           {"write", Tail::Text, false},
    {"command", Tail::Text, false}, {"warn", Tail::Text, false},
    {"error", Tail::Text, false},
}};

void appendEnding(std::string& out, const TraceRecord& record, std::string_view text) {
    switch (record.event) {
    case TraceEvent::SenseEval:
        appendValue(out.append(" -> "), answerOf(record, text));
        out += record.flags & trace_holds ? " T" : " F";
        out += record.flags & trace_cached ? " cached" : "";
        return;
    case TraceEvent::DriveSkipped:
        out += record.skip() == SkipReason::Frequency ? " frequency" : " off";
        return;
    case TraceEvent::ElementSkipped:
        out += " retries";
        return;
    case TraceEvent::DriveInterrupted:
        out += record.flags & trace_adopt_kept ? " (adopt kept)" : "";
        return;
    case TraceEvent::ActRun:
        out.append(" -> ") += toText(record.result());
        return;
    case TraceEvent::ActDone:
        out.append(" ") += toText(record.reason());
        return;
    default:
        return;
    }
}

void appendEvent(std::string& out, const Program& program, const TraceRecord& record, std::string_view text,
                 const Wording& wording) {
    out.append("  ").append(wording.word).append(" ") += pathOf(program, record.place);
    if (wording.tail == Tail::Name)
        out.append(" ") += nameOf(program, record.place);
    else if (wording.tail == Tail::Call)
        out.append(" ") += callTextAt(program, record.place);
    else if (wording.tail == Tail::Text)
        out.append(" ") += text;
    appendEnding(out, record, text);
    out += '\n';
}

} // namespace

std::string_view toText(Outcome outcome) {
    constexpr std::array<std::string_view, 6> words{"Fired", "NoAction", "Idle", "Budget", "GoalSatisfied", "Won"};
    return words[static_cast<std::size_t>(outcome)];
}

std::string_view toText(ActResult result) {
    constexpr std::array<std::string_view, 4> words{"Finished", "RunningOnce", "Running", "Failed"};
    return words[static_cast<std::size_t>(result)];
}

std::string_view toText(DoneReason reason) {
    constexpr std::array<std::string_view, 5> words{"finished", "failed", "interrupted", "goal", "stopped"};
    return words[static_cast<std::size_t>(reason)];
}

Value answerOf(const TraceRecord& record, std::string_view text) {
    switch (record.value) {
    case ValueKind::Nil:
        break;
    case ValueKind::Boolean:
        return record.payload != 0;
    case ValueKind::Integer:
        return static_cast<std::int64_t>(record.payload);
    case ValueKind::Real:
        return std::bit_cast<double>(record.payload);
    case ValueKind::Text:
        return std::string(text);
    case ValueKind::Symbol:
        return Symbol{std::string(text)};
    }
    return std::monostate{};
}

void appendLine(std::string& out, const Program& program, const TraceRecord& record, std::string_view text,
                TraceDetail detail) {
    if (record.event == TraceEvent::CycleBegin) {
        out += "cycle " + std::to_string(record.cycle) + " t=" + std::to_string(record.time_ms) + '\n';
        return;
    }
    if (record.event == TraceEvent::CycleEnd) {
        out.append("end ").append(toText(record.outcome())) += '\n';
        return;
    }
    const bool budget = record.event == TraceEvent::Warning && record.warning() == WarningCode::Budget;
    if (budget && detail == TraceDetail::Plain) {
        out += "  warn budget\n";
        return;
    }
    const auto at = static_cast<std::size_t>(record.event) - static_cast<std::size_t>(TraceEvent::SenseEval);
    if (wordings[at].plain || detail == TraceDetail::Full)
        appendEvent(out, program, record, text, wordings[at]);
}

} // namespace usar::posh
