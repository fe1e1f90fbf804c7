#include "core/mission/reports/recorded_runs.h"

#include <utility>

#include <QFile>

#include "core/agent/published_text.h"
#include "core/link/recording_parts.h"
#include "core/link/recording_reader.h"
#include "core/posh/trace/trace_file.h"

namespace usar::mission {

namespace {

/// Appends a piece to the last trace; a piece that begins as a trace does belongs to a new run.
void append(std::vector<std::string>& traces, const std::string& piece) {
    if (traces.empty() || piece.starts_with(posh::trace_codec::magic))
        traces.emplace_back();
    traces.back() += piece;
}

/// Adds a finished run to those of the same plan.
void close(PlanRuns run, std::vector<PlanRuns>& plans) {
    if (run.statistics.cycles() == 0)
        return;
    for (PlanRuns& known : plans)
        if (known.statistics.add(run.statistics)) {
            ++known.runs;
            return;
        }
    plans.push_back(std::move(run));
}

} // namespace

Result<RecordedTraces> readTraces(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(file.errorString().toStdString(), path.toStdString(), "Check the name");
    if (file.peek(static_cast<qint64>(posh::trace_codec::magic.size())).toStdString() == posh::trace_codec::magic)
        return RecordedTraces{{file.readAll().toStdString()}, {}};
    auto reader = link::RecordingReader::open(path);
    if (!reader)
        return tl::unexpected(reader.error());
    RecordedTraces recorded{{}, (*reader)->survey().complaint()};
    link::PartSeam seam;
    while (const auto record = (*reader)->next()) {
        const bool may_be_trace = !seam.repeats(*record) && record->kind == link::RecordKind::Note &&
                                  record->name == "published" && record->bytes.starts_with("trace");
        const auto published = may_be_trace ? agent::readPublished(record->bytes) : std::nullopt;
        if (const auto* trace = published ? std::get_if<agent::PlanTrace>(&*published) : nullptr)
            append(recorded.traces, trace->bytes);
    }
    if (recorded.traces.empty())
        return failure("no plan ran in this recording", path.toStdString(),
                       "Record a robot whose behavior is a POSH plan");
    return recorded;
}

std::string addRuns(const std::string& trace, std::vector<PlanRuns>& plans) {
    const auto file = posh::TraceFile::open(trace);
    if (!file)
        return file.error().text();
    std::string trouble = file->damage().empty() ? "" : file->damage() + ".";
    PlanRuns run;
    auto cursor = file->begin();
    while (const posh::TracedCycle* const cycle = cursor.next()) {
        if (!cycle->program) {
            trouble = "A plan in the trace cannot be read, and its cycles are left out.";
            continue;
        }
        if (cycle->program != run.statistics.program()) {
            close(std::exchange(run, {}), plans);
            run.runs = 1;
            run.statistics.takeProgram(cycle->program);
        }
        for (const auto* events : {&cycle->events, &cycle->behind})
            for (const posh::trace_codec::Entry& entry : *events)
                run.statistics.take(entry.record, cycle->textOf(entry));
    }
    close(std::move(run), plans);
    return trouble;
}

} // namespace usar::mission
