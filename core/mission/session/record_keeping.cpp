#include "core/mission/session/record_keeping.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <QDateTime>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

namespace {

constexpr std::chrono::milliseconds look_after{500};
constexpr Seconds time_to_object{60.0}; ///< at least, from the warning to the deletion, where a limit was set late

/// Most bytes of a trace in one note. A byte takes up to four characters there, and a note that spreads over two
/// records could not be read.
constexpr std::size_t longest_piece = link::recording::longest_payload_bytes / 8;

std::string wholeSeconds(Seconds span) {
    return spanText(Seconds{std::round(span.count())});
}

std::string rectangleText(const Rectangle& area) {
    std::string text;
    for (const double value : {area.min_m.x(), area.min_m.y(), area.max_m.x(), area.max_m.y()})
        text += (text.empty() ? "" : " ") + shortest(value);
    return text;
}

} // namespace

RecordKeeping::RecordKeeping(QObject& owner, Notices& notices, const Incoming& incoming,
                             std::function<RecordingScene()> scene, std::function<void()> looked)
    : notices_(notices)
    , incoming_(incoming)
    , timer_(&owner)
    , scene_(std::move(scene)) {
    timer_.setInterval(look_after);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, looked = std::move(looked)] {
        look();
        looked();
    });
}

Result<void> RecordKeeping::begin(const QString& path, RecordingFacts facts) {
    end();
    began_ = Clock::now();
    warned_ = false;
    set_late_ = false;
    const RecordingScene scene = scene_();
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
    writer_->writeHead([&] { beginWith(scene); });
    facts_ = std::move(facts);
    timer_.start();
    return {};
}

void RecordKeeping::beginWith(const RecordingScene& scene) {
    const bool connected = scene.link.state == link::LinkState::Connected;
    if (connected) {
        opened(placeOf(scene.link));
        if (!scene.pending.empty())
            received(scene.pending);
        if (scene.robot)
            note("robot", protocol::write(*scene.robot));
    }
    for (const std::string& sentence : faults_.sentences())
        note("fault", sentence);
    if (!connected || !scene.of_behavior)
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
    if (!writer_)
        return;
    if (const auto error = writer_->finish())
        notices_.trouble(Severity::Error, Topic::Recording, error->text());
    sayDropped();
    writer_.reset();
}

void RecordKeeping::setLimit(RecordingLimit limit_bytes) {
    if (limit_bytes)
        limit_bytes = std::max(*limit_bytes, link::RecordingParts::least_limit_bytes);
    if (std::exchange(limit_bytes_, limit_bytes) == limit_bytes)
        return;
    warned_ = false;
    set_late_ = on();
    if (writer_)
        writer_->makeRoom(std::nullopt); // A deletion for the limit before may still wait.
}

std::optional<RecordingFigures> RecordKeeping::figures() const {
    if (!writer_)
        return std::nullopt;
    return RecordingFigures{writer_->path(), elapsed(), writer_->allBytes(), limit_bytes_};
}

void RecordKeeping::sent(const Cause& cause, const std::string& text) {
    const std::string source = toText(cause.source);
    put({.kind = link::RecordKind::Out, .trigger = cause.trigger, .name = source, .bytes = text + "\r\n"});
}

void RecordKeeping::noteFault(const std::string& sentence) {
    faults_.take(sentence);
    note("fault", sentence);
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

void RecordKeeping::note(std::string_view topic, std::string_view text) {
    put({.kind = link::RecordKind::Note, .trigger = incoming_.stateLine(), .name = topic, .bytes = text});
}

void RecordKeeping::put(link::Record record) {
    record.line = incoming_.newest();
    if (writer_)
        writer_->write(record);
}

void RecordKeeping::look() {
    if (!writer_)
        return;
    if (writer_->broken())
        return end();
    sayDropped();
    if (limit_bytes_)
        keepLimit();
}

void RecordKeeping::keepLimit() {
    // In this order, for the sizes are those of the part before until the new one is there.
    if (!writer_->cutting() && link::RecordingParts::isFull(writer_->bytes(), writer_->headBytes(), *limit_bytes_))
        beginNextPart();
    // Nothing is deleted in the same moment in which it is said.
    if (!warned_)
        warn();
    else if (elapsed() >= delete_from_)
        writer_->makeRoom(*limit_bytes_);
}

/// What the session is like now is told once more in the new part, so that it can be read without those before it.
void RecordKeeping::beginNextPart() {
    const Seconds now = elapsed();
    RecordingFacts facts = facts_;
    facts["part"] = std::to_string(writer_->partNumber() + 1);
    facts["began"] = facts_["started"];
    facts["after_s"] = fixed(now.count(), 3);
    facts["started"] = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    writer_->beginPart(facts, incoming_.newest(), now);
    writer_->writeHead([this] {
        beginWith(scene_());
        note(link::part_topic, {});
    });
}

void RecordKeeping::warn() {
    constexpr double near = 0.8;
    const bool is_new = std::exchange(set_late_, false);
    const auto limit = static_cast<double>(*limit_bytes_);
    const auto used = static_cast<double>(writer_->allBytes());
    if (used < near * limit)
        return;
    warned_ = true;
    const double free = std::max(0.0, 0.9 * limit - used); // Until there is no room for another part.
    Seconds left = elapsed() * free / used;
    // All that was recorded before the limit was set is one part, and would go as a whole; there is time to raise it.
    const bool is_late = is_new && left < time_to_object;
    if (is_late)
        left = time_to_object;
    delete_from_ = is_late ? elapsed() + time_to_object : Seconds{0.0};
    notices_.say(Severity::Warning, Topic::Recording,
                 "The recording has " + link::megabytesText(writer_->allBytes()) + " of the " +
                     link::megabytesText(*limit_bytes_) + " that it may have. In about " + wholeSeconds(left) +
                     " its oldest part is deleted, and so on from then on. Raise the limit to keep it.",
                 "limit");
}

void RecordKeeping::sayDropped() {
    for (const auto& dropped : writer_->takeDropped()) {
        if (!dropped) {
            notices_.say(Severity::Warning, Topic::Recording, dropped.error().text(), "limit");
            continue;
        }
        const std::string part = "The oldest part of the recording, " + dropped->path + " with " +
                                 link::megabytesText(dropped->bytes) + ", ";
        notices_.say(Severity::Note, Topic::Recording,
                     part +
                         (dropped->deleted ? "was deleted to keep the limit"
                                           : "was moved or deleted by somebody else and counts no more") +
                         "; the recording now begins after " + wholeSeconds(dropped->end) + '.',
                     "part");
    }
}

} // namespace usar::mission
