#include "core/mission/session/record_keeping.h"

#include <chrono>
#include <utility>

#include <QDateTime>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

namespace {

constexpr std::chrono::milliseconds look_after{500};

/// Most bytes of a trace in one note. A byte takes up to four characters there, and a note that spreads over two
/// records could not be read.
constexpr std::size_t longest_piece = link::recording::longest_payload_bytes / 8;

std::string rectangleText(const Rectangle& area) {
    std::string text;
    for (const double value : {area.min_m.x(), area.min_m.y(), area.max_m.x(), area.max_m.y()})
        text += (text.empty() ? "" : " ") + shortest(value);
    return text;
}

} // namespace

RecordKeeping::RecordKeeping(QObject& owner, Notices& notices, const Incoming& incoming, std::function<void()> looked)
    : notices_(notices)
    , incoming_(incoming)
    , timer_(&owner) {
    timer_.setInterval(look_after);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, looked = std::move(looked)] {
        look();
        looked();
    });
}

Result<void> RecordKeeping::begin(const QString& path, RecordingFacts facts, const RecordingScene& scene) {
    end();
    if (!scene.link.host.isEmpty()) {
        facts["host"] = scene.link.host.toStdString();
        facts["port"] = std::to_string(scene.link.port);
    }
    facts["started"] = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    facts["cell_size_m"] = shortest(scene.cell_size_m);
    if (!scene.level.empty())
        facts["level"] = scene.level;
    auto made = link::RecordingWriter::create(path, facts, incoming_.newest());
    if (!made)
        return tl::unexpected(made.error());
    writer_ = *std::move(made);
    timer_.start();
    if (scene.link.state == link::LinkState::Connected)
        beginWith(scene);
    return {};
}

void RecordKeeping::beginWith(const RecordingScene& scene) {
    opened(placeOf(scene.link));
    if (!scene.pending.empty())
        received(scene.pending);
    if (scene.robot)
        note("robot", protocol::write(*scene.robot));
    if (!scene.of_behavior)
        return;
    noteMission(mission_);
    noteTask(*scene.of_behavior);
    for (const agent::MapMark& mark : scene.of_behavior->marks)
        write(mark);
    for (const agent::Published& value : so_far_.all())
        write(value);
}

void RecordKeeping::end() {
    timer_.stop();
    writer_.reset();
}

std::optional<RecordingFigures> RecordKeeping::figures() const {
    if (!writer_)
        return std::nullopt;
    return RecordingFigures{writer_->path(), writer_->elapsed(), writer_->bytes()};
}

void RecordKeeping::sent(const Cause& cause, const std::string& text) {
    const std::string source = toText(cause.source);
    put({.kind = link::RecordKind::Out, .trigger = cause.trigger, .name = source, .bytes = text + "\r\n"});
}

void RecordKeeping::noteTask(const ScanRecord& record) {
    note("behavior", record.behavior_id + '\t' + record.robot_name + '\t' + rectangleText(record.area_in_map));
}

void RecordKeeping::noteMission(const std::string& text) {
    mission_ = text;
    if (!text.empty())
        note("mission", text);
}

void RecordKeeping::notePublished(const agent::Published& value, bool runs_here) {
    if (runs_here)
        so_far_.take(value);
    write(value);
}

void RecordKeeping::write(const agent::Published& value) {
    if (!writer_)
        return;
    const auto* const trace = std::get_if<agent::PlanTrace>(&value);
    if (trace && trace->bytes.size() > longest_piece) {
        for (std::size_t at = 0; at < trace->bytes.size(); at += longest_piece)
            write(agent::PlanTrace{trace->bytes.substr(at, longest_piece)});
        return;
    }
    std::string text;
    appendText(text, value);
    note("published", text);
}

void RecordKeeping::noteFinished(const agent::BehaviorFinished& finished) {
    note("finished", (finished.success ? "1 " : "0 ") + finished.reason);
}

void RecordKeeping::note(const char* topic, std::string_view text) {
    put({.kind = link::RecordKind::Note, .trigger = incoming_.stateLine(), .name = topic, .bytes = text});
}

void RecordKeeping::put(link::Record record) {
    record.line = incoming_.newest();
    if (writer_)
        writer_->write(record);
}

void RecordKeeping::look() {
    if (!writer_ || !writer_->broken())
        return;
    if (const auto error = writer_->takeTrouble())
        notices_.trouble(Severity::Error, Topic::Recording, error->text());
    end();
}

} // namespace usar::mission
