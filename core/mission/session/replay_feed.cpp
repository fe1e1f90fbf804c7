#include "core/mission/session/replay_feed.h"

#include <algorithm>
#include <utility>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/mission/session/behavior_so_far.h"
#include "core/protocol/command_reader.h"

namespace usar::mission {

namespace {

std::string_view takeUntilTab(std::string_view& text) {
    const std::string_view part = text.substr(0, text.find('\t'));
    text.remove_prefix(std::min(text.size(), part.size() + 1));
    return part;
}

Rectangle readRectangle(std::string_view text) {
    Rectangle area;
    for (double* value : {&area.min_m.x(), &area.min_m.y(), &area.max_m.x(), &area.max_m.y()})
        *value = readNumber(takeWord(text)).value_or(0.0);
    return area;
}

std::string_view withoutEnd(std::string_view line) {
    return line.substr(0, line.find_last_not_of("\r\n") + 1);
}

} // namespace

void ReplayFeed::begin(std::unique_ptr<link::RecordingReader> recording) {
    const RecordingFacts& facts = recording->survey().facts;
    const auto fact = [&](const char* key) {
        const auto found = facts.find(key);
        return found == facts.end() ? std::string() : found->second;
    };
    link_ = {};
    link_.host = QString::fromStdString(fact("host"));
    link_.port = static_cast<quint16>(readInteger(fact("port")).value_or(0));
    std::optional<double> cell_size_m = readNumber(fact("cell_size_m"));
    if (cell_size_m && !(*cell_size_m > 0.0))
        cell_size_m.reset();
    const std::string level = fact("level");
    link::ReplayTaker& taker = *this;
    replayer_ = std::make_unique<link::Replayer>(std::move(recording), taker);
    rewound();
    stage_.replayBegan(cell_size_m, level);
    QObject::connect(replayer_.get(), &link::Replayer::changed, replayer_.get(), [this] { stage_.replayChanged(); });
    QObject::connect(replayer_.get(), &link::Replayer::ended, replayer_.get(), [this] { stage_.replayEnds(); });
    QObject::connect(replayer_.get(), &link::Replayer::damaged, replayer_.get(),
                     [this] { stage_.replayDamaged(replayer_->survey().complaint()); });
    setLink(link::LinkState::Connecting, {});
}

void ReplayFeed::order(const ReplayOrder& order) {
    if (!replayer_)
        return;
    if (order.speed)
        replayer_->setSpeed(*order.speed);
    if (order.seek)
        replayer_->seek(*order.seek);
    if (order.seek_clock)
        replayer_->seekToClock(*order.seek_clock);
    if (order.seek_by)
        replayer_->seek(replayer_->figures().position + *order.seek_by);
    if (order.play)
        replayer_->setPlaying(*order.play);
    if (order.step)
        replayer_->step();
    stage_.replayChanged();
}

void ReplayFeed::end() {
    on_the_way_ = false;
    replayer_.reset();
}

std::optional<link::ReplayFigures> ReplayFeed::figures() const {
    return replayer_ ? std::optional(replayer_->figures()) : std::nullopt;
}

void ReplayFeed::setLink(link::LinkState now, std::string_view reason) {
    link_.state = now;
    link_.trouble = link_.reason = QString::fromUtf8(reason);
    if (!on_the_way_)
        stage_.replayLinkChanged(link_);
}

void ReplayFeed::rewound() {
    newest_on_the_way_.clear();
    stage_.replayRewound();
}

void ReplayFeed::opened(std::string_view) {
    stage_.replayConnected();
    setLink(link::LinkState::Connected, {});
    stage_.replayChanged();
}

/// If we closed the connection, as at the end of every recording, the last values stay valid; a lost connection makes
/// them stale.
void ReplayFeed::closed(std::string_view reason) {
    const bool lost = !reason.empty();
    stage_.replayClosed(lost);
    if (lost)
        setLink(link::LinkState::Disconnected, reason);
}

void ReplayFeed::line(std::string_view text, LineNumber number) {
    ++traffic_.lines_in;
    traffic_.bytes_in += text.size() + 2;
    stage_.replayLine(text, number);
}

void ReplayFeed::sent(const link::Record& out) {
    const std::string_view text = withoutEnd(out.bytes);
    ++traffic_.lines_out;
    traffic_.bytes_out += out.bytes.size();
    Diagnostics ignored;
    stage_.replayCommand(
        {protocol::readCommand(text, ignored, stage_.replaySpelling()), {by::readSource(out.name), out.trigger}},
        std::string(text), out.line);
    stage_.replayChanged();
}

void ReplayFeed::note(const link::Record& record) {
    if (record.name == "published") {
        if (const auto value = agent::readPublished(record.bytes))
            takePublished(*value);
    } else if (record.name == "robot") {
        sent({.kind = link::RecordKind::Out, .line = record.line, .name = "session: spawn", .bytes = record.bytes});
    } else if (record.name == "fault") {
        stage_.replayFault(std::string(record.bytes));
    } else if (record.name == "mission") {
        stage_.replayMission(record.bytes);
    } else if (record.name == "behavior") {
        takeTask(record.bytes);
    } else if (record.name == "finished") {
        stage_.replayFinished(
            {record.bytes.starts_with('1'), std::string(record.bytes.substr(record.bytes.find(' ') + 1))});
    }
    stage_.replayChanged();
}

void ReplayFeed::takeTask(std::string_view text) {
    const std::string_view behavior_id = takeUntilTab(text);
    const std::string_view robot_name = takeUntilTab(text);
    passNewest(); // They belong to the behavior before, so they may not come after this one has begun.
    stage_.replayTask({std::string(behavior_id), readRectangle(text)}, std::string(robot_name));
}

void ReplayFeed::takePublished(const agent::Published& value) {
    if (!on_the_way_ || !replacesItsPredecessor(value))
        return stage_.replayPublished(value);
    newest_on_the_way_.insert_or_assign(value.index(), value);
    if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
        stage_.replayPassed(*status);
}

void ReplayFeed::passNewest() {
    for (const auto& [kind, value] : std::exchange(newest_on_the_way_, {}))
        stage_.replayPublished(value);
}

void ReplayFeed::quiet(bool on) {
    on_the_way_ = on;
    stage_.replaySeeks(on);
    if (on)
        return;
    passNewest();
    stage_.replayLinkChanged(link_);
    stage_.replayChanged();
}

} // namespace usar::mission
