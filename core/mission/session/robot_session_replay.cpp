// Replay in a session: the lines come from a recording and are processed like live ones, and nothing is sent.
#include "core/mission/session/robot_session_private.h"

#include <utility>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
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

void RobotSession::openRecording(const QString& path) {
    close();
    auto recording = link::RecordingReader::open(path);
    if (!recording) {
        emit replayFailed(QString::fromStdString(recording.error().text()));
        return;
    }
    const link::RecordingSurvey survey = (*recording)->survey();
    d_->beginReplay(*std::move(recording));
    emit replayOpened(survey.facts, QString::fromStdString(survey.complaint()));
    d_->touched();
}

void RobotSession::orderReplay(const ReplayOrder& order) {
    if (!d_->replayer)
        return;
    if (order.speed)
        d_->replayer->setSpeed(*order.speed);
    if (order.seek)
        d_->replayer->seek(*order.seek);
    if (order.seek_clock)
        d_->replayer->seekToClock(*order.seek_clock);
    if (order.seek_by)
        d_->replayer->seek(d_->replayer->figures().position + *order.seek_by);
    if (order.play)
        d_->replayer->setPlaying(*order.play);
    if (order.step)
        d_->replayer->step();
    d_->touched();
}

void RobotSession::Private::beginReplay(std::unique_ptr<link::RecordingReader> recording) {
    const auto& facts = recording->survey().facts;
    const auto fact = [&](const char* key) {
        const auto found = facts.find(key);
        return found == facts.end() ? std::string() : found->second;
    };
    replay_link = {};
    replay_link.host = QString::fromStdString(fact("host"));
    replay_link.port = static_cast<quint16>(readInteger(fact("port")).value_or(0));
    replayer = std::make_unique<link::Replayer>(std::move(recording), *this);
    if (const auto cell_size_m = readNumber(fact("cell_size_m")); cell_size_m && *cell_size_m > 0.0)
        mapper.clearMap(cell_size_m);
    rewound();
    record.level = fact("level");
    connect(replayer.get(), &link::Replayer::changed, &q, [this] { touched(); });
    connect(replayer.get(), &link::Replayer::ended, &q, &RobotSession::replayEnded);
    setReplayLink(link::LinkState::Connecting, {});
}

void RobotSession::Private::endReplay() {
    if (!replayer)
        return;
    on_the_way = false;
    figures.behavior_running = false;
    replayer.reset();
    troubles.erase("replay");
}

bool RobotSession::Private::refusedInReplay() {
    if (replayer && !troubles.contains("replay"))
        trouble(Severity::Warning, "replay",
                "This is a replay: nothing can be sent, for all of it has happened. Connect to a server and spawn a "
                "robot to drive one.");
    return replayer != nullptr;
}

void RobotSession::Private::setReplayLink(link::LinkState now, std::string_view reason) {
    replay_link.state = now;
    replay_link.trouble = replay_link.reason = QString::fromUtf8(reason.data(), static_cast<qsizetype>(reason.size()));
    if (!on_the_way)
        emit q.linkChanged(replay_link);
}

void RobotSession::Private::rewound() {
    const std::string level = record.level;
    beginConnection();
    complaints = {};
    complaints_before = 0;
    mapper.clearMap();
    record = {};
    record.level = level;
    figures = {};
    newest_on_the_way.clear();
    unplaced_said = false;
    collector.rewind();
    touched();
}

void RobotSession::Private::opened(std::string_view) {
    beginConnection();
    setReplayLink(link::LinkState::Connected, {});
    touched();
}

/// If we closed the connection, as at the end of every recording, the last values stay valid; a lost connection makes
/// them stale.
void RobotSession::Private::closed(std::string_view reason) {
    figures.behavior_running = false;
    if (reason.empty())
        return;
    setReplayLink(link::LinkState::Disconnected, reason);
    setSpawn(SpawnState::None);
    figures.lockstep = false;
}

void RobotSession::Private::line(std::string_view text, LineNumber number) {
    reader.continueAfter({number.value - 1});
    figures.lines_received = number.value - 1;
    ++replay_traffic.lines_in;
    replay_traffic.bytes_in += text.size() + 2;
    takeLine(text);
}

void RobotSession::Private::sent(const link::Record& out) {
    const std::string_view text = withoutEnd(out.bytes);
    ++replay_traffic.lines_out;
    replay_traffic.bytes_out += out.bytes.size();
    Diagnostics ignored;
    const protocol::Dialect spelling = dialect.dialect().value_or(protocol::Dialect::Ut2004);
    agent::CausedCommand command{protocol::readCommand(text, ignored, spelling), {std::string(out.name), out.trigger}};
    dialect.sent(command.command);
    if (const auto* asked = std::get_if<protocol::Init>(&command.command)) {
        request.class_name = asked->class_name;
        request.robot_name = asked->robot_name;
        setSpawn(SpawnState::Asked);
    }
    figures.steps_sent += std::holds_alternative<protocol::Step>(command.command);
    if (observed)
        collector.addCommand({std::move(command), std::string(text), out.line, figures.now});
    touched();
}

void RobotSession::Private::note(const link::Record& record_) {
    if (record_.name == "published") {
        if (const auto value = agent::readPublished(record_.bytes))
            takeReplayed(*value);
    } else if (record_.name == "robot") {
        sent({.kind = link::RecordKind::Out, .line = record_.line, .name = "session: spawn", .bytes = record_.bytes});
    } else if (record_.name == "fault") {
        q.noteFault(std::string(record_.bytes));
    } else if (record_.name == "behavior") {
        std::string_view rest = record_.bytes;
        record.behavior_id = takeUntilTab(rest);
        record.robot_name = takeUntilTab(rest);
        record.area_in_map = readRectangle(rest);
        record.status = {};
        figures.behavior_running = true;
        collector.addTask({record.behavior_id, record.area_in_map});
    } else if (record_.name == "finished") {
        finishBehavior({record_.bytes.starts_with('1'), std::string(record_.bytes.substr(record_.bytes.find(' ') + 1))},
                       false);
    }
    touched();
}

/// During a seek, only values that add up are taken; of all others the newest is enough, and an hour of them would be
/// too much.
void RobotSession::Private::takeReplayed(const agent::Published& value) {
    const bool replaced =
        std::holds_alternative<agent::BehaviorStatus>(value) || std::holds_alternative<agent::SonarZones>(value) ||
        std::holds_alternative<agent::PlannedPath>(value) || std::holds_alternative<agent::CurrentGoal>(value);
    if (!on_the_way || !replaced)
        return takePublished({value});
    newest_on_the_way.insert_or_assign(value.index(), value);
    if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
        record.status = *status;
}

void RobotSession::Private::quiet(bool on) {
    on_the_way = on;
    frame_timer.stop();
    if (on)
        return;
    for (const auto& [kind, value] : std::exchange(newest_on_the_way, {}))
        takePublished({value});
    emit q.linkChanged(replay_link);
    touched();
}

} // namespace usar::mission
