// A trace as text with one line per event, for golden traces and for comparing runs.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/posh/run/trace_event.h"
#include "core/posh/run/value_text.h"

namespace usar::test {

/// The level of detail. Plain: only senses, decisions and acts, for comparing traces of different engines. Full: also
/// pushes and pops, warnings, errors, blackboard changes and commands.
enum class TraceDetail { Plain, Full };

/// Returns the word that a trace has for it: "Fired".
inline std::string_view wordOf(posh::Outcome outcome) {
    constexpr std::array<std::string_view, 6> words{"Fired", "NoAction", "Idle", "Budget", "GoalSatisfied", "Won"};
    return words[static_cast<std::size_t>(outcome)];
}

/// Returns the word that a trace has for it: "interrupted".
inline std::string_view wordOf(posh::DoneReason reason) {
    constexpr std::array<std::string_view, 5> words{"finished", "failed", "interrupted", "goal", "stopped"};
    return words[static_cast<std::size_t>(reason)];
}

/// The format of an event's line: a word, the path of the place, then the item given by `Tail`.
struct TraceWording {
    enum class Tail { Nothing, Name, Call, Text };
    std::string_view word;
    Tail tail = Tail::Nothing;
    bool plain = true; ///< whether TraceDetail::Plain includes the event
};

/// Returns the format of any event from SenseEval to Error.
inline const TraceWording& wordingOf(posh::TraceEvent event) {
    using Tail = TraceWording::Tail;
    static constexpr std::array<TraceWording, 21> wordings{{
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
    return wordings[static_cast<std::size_t>(event) - static_cast<std::size_t>(posh::TraceEvent::SenseEval)];
}

/// Appends what an event's line has behind its item, such as an answer or a result.
inline void appendEnding(std::string& out, const posh::TraceRecord& record, std::string_view text) {
    using enum posh::TraceEvent;
    switch (record.event) {
    case SenseEval:
        appendValue(out.append(" -> "), answerOf(record, text));
        out += record.flags & posh::trace_holds ? " T" : " F";
        out += record.flags & posh::trace_cached ? " cached" : "";
        return;
    case DriveSkipped:
        out += record.skip() == posh::SkipReason::Frequency ? " frequency" : " off";
        return;
    case ElementSkipped:
        out += " retries";
        return;
    case DriveInterrupted:
        out += record.flags & posh::trace_adopt_kept ? " (adopt kept)" : "";
        return;
    case ActRun:
        out.append(" -> ") += toText(record.result());
        return;
    case ActDone:
        out.append(" ") += wordOf(record.reason());
        return;
    default:
        return;
    }
}

/// Appends the line of an event from SenseEval to Error.
inline void appendEvent(std::string& out, const posh::Program& program, const posh::TraceRecord& record,
                        std::string_view text) {
    const TraceWording& wording = wordingOf(record.event);
    out.append("  ").append(wording.word).append(" ") += pathOf(program, record.place);
    if (wording.tail == TraceWording::Tail::Name)
        out.append(" ") += nameOf(program, record.place);
    else if (wording.tail == TraceWording::Tail::Call)
        out.append(" ") += callTextAt(program, record.place);
    else if (wording.tail == TraceWording::Tail::Text)
        out.append(" ") += text;
    appendEnding(out, record, text);
    out += '\n';
}

/// Appends the line of one record with its line end, or nothing if the level of detail leaves the event out.
inline void appendLine(std::string& out, const posh::Program& program, const posh::TraceRecord& record,
                       std::string_view text, TraceDetail detail = TraceDetail::Plain) {
    const bool is_plain = detail == TraceDetail::Plain;
    if (record.event == posh::TraceEvent::CycleBegin)
        out += "cycle " + std::to_string(record.cycle) + " t=" + std::to_string(record.time_ms) + '\n';
    else if (record.event == posh::TraceEvent::CycleEnd)
        out.append("end ").append(wordOf(record.outcome())) += '\n';
    else if (is_plain && record.event == posh::TraceEvent::Warning && record.warning() == posh::WarningCode::Budget)
        out += "  warn budget\n";
    else if (!is_plain || wordingOf(record.event).plain)
        appendEvent(out, program, record, text);
}

/// Collects the text of a run while it happens.
class TraceText final : public posh::TraceObserver {
public:
    explicit TraceText(TraceDetail detail = TraceDetail::Plain) : detail_(detail) {}
    void takeProgram(const std::shared_ptr<const posh::Program>& program) override { program_ = program; }
    void take(const posh::TraceRecord& record, std::string_view text) override {
        appendLine(text_, *program_, record, text, detail_);
    }
    const std::string& text() const { return text_; }
    void clear() { text_.clear(); }

private:
    TraceDetail detail_;
    std::shared_ptr<const posh::Program> program_;
    std::string text_;
};

} // namespace usar::test
