// Recording of a session while it runs.
#include "core/mission/session/robot_session_private.h"

#include <utility>

#include <QDateTime>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/link/across_threads.h"
#include "core/link/recording_format.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

namespace {

constexpr std::chrono::milliseconds look_after{500};

/// Most bytes of a trace in one note. A byte takes up to four characters there, and a note that spreads over two
/// records could not be read.
constexpr std::size_t longest_piece = link::recording::longest_payload_bytes / 8;

std::string rectangleText(const Rectangle& area) {
    std::string text;
    for (const double value : {area.min_m.x(), area.min_m.y(), area.max_m.x(), area.max_m.y()}) {
        text += text.empty() ? "" : " ";
        appendShortest(text, value);
    }
    return text;
}

} // namespace

Result<void> RobotSession::startRecording(const QString& path, const RecordingFacts& facts) {
    stopRecording();
    Result<void> begun =
        d_->replayer
            ? Result<void>(failure("a replay is not recorded once more", path.toStdString(), "It has a file already"))
            : d_->beginRecording(path, facts);
    if (begun)
        d_->over("recording");
    else
        d_->trouble(Severity::Error, "recording", begun.error().text());
    d_->touched();
    return begun;
}

void RobotSession::stopRecording() {
    d_->endRecording();
    d_->touched();
}

void RobotSession::flushRecording() {
    if (!d_->recorder)
        return emit recordingFlushed({});
    const QString path = QString::fromStdString(d_->recorder->path());
    // Called in the recorder's thread, which ends before this object does.
    d_->recorder->flush([this, path] { link::post(this, [this, path] { emit recordingFlushed(path); }); });
}

Result<void> RobotSession::Private::beginRecording(const QString& path, RecordingFacts facts) {
    if (!link.status().host.isEmpty()) {
        facts["host"] = link.status().host.toStdString();
        facts["port"] = std::to_string(link.status().port);
    }
    facts["started"] = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    facts["cell_size_m"].clear();
    appendShortest(facts["cell_size_m"], mapper.map().cellSize_m());
    if (!record.level.empty())
        facts["level"] = record.level;
    const LineNumber line{figures.lines_received};
    auto made = link::RecordingWriter::create(path, facts, line);
    if (!made)
        return tl::unexpected(made.error());
    recorder = *std::move(made);
    recording_timer.start(look_after);
    if (!connected())
        return {};
    recorder->write({.kind = link::RecordKind::Opened, .line = line, .bytes = placeOf(link.status())});
    if (!link.pending().empty())
        recorder->write({.kind = link::RecordKind::In, .line = line, .bytes = link.pending()});
    if (const auto init = initOf(request);
        init && (figures.spawn == SpawnState::Asked || figures.spawn == SpawnState::Done))
        noteForRecording("robot", protocol::write(*init));
    if (!host)
        return {};
    noteTask();
    for (const agent::MapMark& mark : record.marks)
        notePublished(mark);
    for (const agent::Published& value : so_far.all())
        notePublished(value);
    return {};
}

void RobotSession::Private::noteTask() {
    noteForRecording("behavior",
                     record.behavior_id + '\t' + record.robot_name + '\t' + rectangleText(record.area_in_map));
}

void RobotSession::Private::noteForRecording(const char* topic, std::string_view text) {
    if (recorder)
        recorder->write({.kind = link::RecordKind::Note,
                         .line = {figures.lines_received},
                         .trigger = state->line(),
                         .name = topic,
                         .bytes = text});
}

void RobotSession::Private::notePublished(const agent::Published& value) {
    if (!recorder)
        return;
    const auto* const trace = std::get_if<agent::PlanTrace>(&value);
    if (trace && trace->bytes.size() > longest_piece) {
        for (std::size_t at = 0; at < trace->bytes.size(); at += longest_piece)
            notePublished(agent::PlanTrace{trace->bytes.substr(at, longest_piece)});
        return;
    }
    std::string text;
    appendText(text, value);
    noteForRecording("published", text);
}

void RobotSession::Private::watchRecording() {
    if (recorder && recorder->broken()) {
        if (const auto error = recorder->takeTrouble())
            trouble(Severity::Error, "recording", error->text());
        endRecording();
    }
    touched();
}

void RobotSession::Private::endRecording() {
    recording_timer.stop();
    recorder.reset();
}

} // namespace usar::mission
