// A trace as text, a line an event: what golden traces, reports and people read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/posh/trace_event.h"

namespace usar::posh {

/// Plain: decisions and acts only, the form that traces of different engines are compared in. Full: pushes and pops,
/// warnings, errors, blackboard and commands too.
enum class TraceDetail { Plain, Full };

/// Appends the lines of one record, each with its line end; nothing for what the detail leaves out.
void appendLine(std::string& out, const Program& program, const TraceRecord& record, std::string_view text,
                TraceDetail detail = TraceDetail::Plain);

std::string_view toText(Outcome outcome);
std::string_view toText(ActResult result);
std::string_view toText(DoneReason reason);

/// Writes down a run as it happens.
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
