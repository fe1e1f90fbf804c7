// A trace as text with one line per event, for golden traces, reports and users.
#pragma once

#include <string>
#include <string_view>

#include "core/posh/run/trace_event.h"

namespace usar::posh {

/// The level of detail. Plain: only senses, decisions and acts, for comparing traces of different engines. Full: also
/// pushes and pops, warnings, errors, blackboard changes and commands.
enum class TraceDetail { Plain, Full };

/// Appends the line of one record with its line end, or nothing if the level of detail leaves the event out.
void appendLine(std::string& out, const Program& program, const TraceRecord& record, std::string_view text,
                TraceDetail detail = TraceDetail::Plain);

/// These return the words used in traces: "Fired", "RunningOnce", "interrupted".
std::string_view toText(Outcome outcome);
std::string_view toText(ActResult result);
std::string_view toText(DoneReason reason);

/// Collects the text of a run while it happens.
class TraceText final : public TraceObserver {
public:
    explicit TraceText(TraceDetail detail = TraceDetail::Plain) : detail_(detail) {}
    void takeProgram(const std::shared_ptr<const Program>& program) override { program_ = program; }
    void take(const TraceRecord& record, std::string_view text) override {
        appendLine(text_, *program_, record, text, detail_);
    }
    const std::string& text() const { return text_; }
    void clear() { text_.clear(); }

private:
    TraceDetail detail_;
    std::shared_ptr<const Program> program_;
    std::string text_;
};

} // namespace usar::posh
