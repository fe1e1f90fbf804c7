// The life of a session: connection, lines, behavior, replay. Each part does its own; the order is decided here.
#include "core/mission/session/robot_session_private.h"

#include <functional>
#include <span>
#include <utility>

#include <QMetaMethod>
#include <QTimer>

#include "core/base/numbers.h"
#include "core/mission/files/flown_mission.h"
#include "core/mission/session/stream_name.h"

namespace usar::mission {

RobotSession::Private::Private(RobotSession& session, double cell_size_m)
    : q(session)
    , link(&session)
    , watch_timer(&session)
    , notices([this](const Notice& notice) { emit q.noticed(notice); })
    , updates(
          session, [this] { return q.isSignalConnected(QMetaMethod::fromSignal(&RobotSession::updated)); },
          [this] { emit q.updated(updates.take(book.mapper(), figures(), book.correctedPath_m())); })
    , book(cell_size_m, notices)
    , vigil(notices)
    , spawning(*this, notices)
    , records(
          session, notices, incoming, [this] { return scene(); }, [this] { touched(); })
    , helm(session, *this, {incoming, spawning, notices, vigil})
    , replay(*this) {
    clock.start();
    watch_timer.setInterval(toMilliseconds(limits.stale) / 8);
    connect(&watch_timer, &QTimer::timeout, &q, [this] { watch(); });
    link.setLineTaker(std::bind_front(&Private::takeLine, this));
    link.setAheadTaker(
        [this](std::span<const std::string_view> lines) { helm.expect({incoming.newest().value + 1}, lines); });
    link.setByteTaker(std::bind_front(&RecordKeeping::received, &records));
    connect(&link, &link::TcpLink::statusChanged, &q, &RobotSession::linkChanged);
    connect(&link, &link::TcpLink::opened, &q, [this] { opened(); });
    connect(&link, &link::TcpLink::closed, &q, [this] {
        records.closed(link.status().trouble.toStdString());
        connectionLost();
    });
}

RecordingScene RobotSession::Private::scene() const {
    return {.link = link.status(),
            .pending = link.pending(),
            .cell_size_m = book.cellSize_m(),
            .level = book.record().level,
            .robot = spawning.standingInit(),
            .of_behavior = helm.hasBehavior() ? &book.record() : nullptr};
}

void RobotSession::Private::beginConnection() {
    incoming.beginConnection();
    vigil.beginConnection();
    helm.beginConnection();
    book.beginConnection();
    spawning.beginConnection();
    replay.beginConnection();
    updates.lookForObservers(); // Without this, observers would miss the greeting, which comes before the first frame.
}

void RobotSession::Private::opened() {
    beginConnection();
    records.opened(placeOf(link.status()));
    if (lockstep_wanted)
        helm.sendForSession(protocol::Lockstep{}, "connect");
    helm.sendForSession(protocol::GetStartPoses{}, "connect");
    vigil.connected(wall());
    watch_timer.start();
    spawning.connected(wall());
    link.flush();
}

void RobotSession::Private::connectionLost() {
    watch_timer.stop();
    const SpawnState lost = spawning.loseConnection();
    helm.loseConnection();
    notices.endThoseOfTheConnection();
    helm.endControl("the connection was lost");
    spawning.reportLoss(lost);
    if (helm.hasBehavior())
        finishBehavior({false, "The connection to the server was lost."}, false);
    spawning.reportRefusal(lost);
    touched();
}

void RobotSession::Private::takeLine(std::string_view text) {
    const protocol::InfoLine& line = incoming.take(text);
    helm.hear(text, line);
    if (const auto complaint = incoming.judge(line))
        notices.say(Severity::Warning, Topic::DamagedLine, complaint->text, complaint->kind);
    if (isRobotData(line.message)) {
        vigil.heardRobot(line.message, spawning.robotName(), incoming.now(), wall());
        spawning.heard();
    }
    book.take(line);
    if (const auto* answer = std::get_if<protocol::LockstepInfo>(&line.message)) {
        helm.setLockstep(answer->on);
    } else if (const auto* poses = std::get_if<protocol::StartPoses>(&line.message)) {
        vigil.heardStartPoses();
        emit q.startPosesKnown(*poses, QString::fromStdString(book.record().level));
    } else if (const auto* response = std::get_if<protocol::Response>(&line.message)) {
        spawning.answered(*response);
    }
    spawning.passed(incoming.now());
    updates.addLine(line); // First, so that the frame of a finished behavior contains its last line.
    helm.answer(line);
    claims.take(line, incoming.now());
    endAtLimit();
    endWithClaims();
    lookForAwaitedTime();
    updates.touched();
}

/// On the protocol clock, so that equal runs end at equal moments, however fast they are.
void RobotSession::Private::endAtLimit() {
    const Seconds since = std::max(behavior_since, spawning.spawnedAt());
    if (!helm.hasBehavior() || since.count() == 0.0 || incoming.now() - since <= limits.flight)
        return;
    const double limit_s = limits.flight.count();
    const std::string limit = limit_s < 3600.0 ? fixed(limit_s, 0) + " s" : fixed(limit_s / 3600.0, 2) + " h";
    helm.stopBehavior(
        by::Session{"time limit"},
        "The mission took longer than its limit of " + limit +
            ". Give it more time (--limit, \"limit_h\", or Time limit in the window), or make the area smaller.");
}

void RobotSession::Private::endWithClaims() {
    if (helm.hasBehavior() && claims.decided())
        helm.stopBehavior(by::Session{"claims"}, claims.sentence());
}

void RobotSession::Private::lookForAwaitedTime() {
    if (!awaited || incoming.now() < *awaited)
        return;
    awaited.reset();
    emit q.timeReached();
}

void RobotSession::Private::watch() {
    const Seconds now = wall();
    vigil.lookForStartPoses(now);
    spawning.look(now, limits.spawn);
    if (spawning.done() && !spawning.isStation() && !helm.timeIsHeld())
        vigil.lookForRobot(spawning.robotName(), now);
    vigil.lookForSensors(incoming.now(), incoming.batteryIsEmpty());
    vigil.lookAtQueue(link.unsentBytes(), placeOf(link.status()));
    helm.look();
    vigil.lookAtOverlong(link.overlongCount());
    touched();
}

void RobotSession::Private::takePublished(const std::vector<agent::Published>& published) {
    updates.addPublished(published);
    for (const agent::Published& value : published) {
        records.notePublished(value, helm.hasBehavior());
        book.take(value);
        claims.take(value);
        if (const auto* event = std::get_if<agent::BehaviorEvent>(&value)) {
            notices.say(event->severity, Topic::Behavior, event->text, event->text);
        } else if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value)) {
            helm.makeSafe(by::Session{"behavior finished"});
            if (!finished->sensors_missing.empty() && !equipment_advice.empty() && !replaying())
                notices.say(Severity::Warning, Topic::Behavior, equipment_advice, "equipment");
            finishBehavior(*finished, true);
        }
    }
}

/// Emits a last frame first, so that receivers of the end have the figures that belong to it.
void RobotSession::Private::finishBehavior(const agent::BehaviorFinished& finished, bool is_published) {
    const agent::BehaviorFinished end = finished; // The argument may be a part of what the behavior answered.
    if (!is_published)
        records.noteFinished(end);
    records.forgetBehavior();
    const bool broke = helm.dismiss();
    book.endTask();
    behavior_running = false;
    updates.lookForObservers();
    if (!is_published)
        updates.addPublished({end});
    updates.showNow();
    if (replaying())
        adjustReplay();
    else
        emit q.behaviorFinished(end.success, QString::fromStdString(end.reason), broke);
}

void RobotSession::Private::sendInit(const protocol::Init& init) {
    helm.sendForSession(init, "spawn");
    link.flush();
}

void RobotSession::Private::reconnect() {
    const link::LinkStatus status = link.status();
    link.open(status.host, status.port);
}

void RobotSession::Private::writeLine(const agent::CausedCommand& command, std::string text) {
    if (connected())
        records.sent(command.cause, text);
    link.send(text);
    book.takeSent(command.command);
    updates.addCommand(command, std::move(text), incoming.newest(), incoming.now());
}

SessionFigures RobotSession::Private::figures() const {
    SessionFigures figures;
    figures.traffic = replaying() ? replay.traffic() : link.counts();
    figures.round_trip = replaying() ? std::nullopt : link.roundTrip();
    incoming.describe(figures);
    helm.describe(figures);
    spawning.describe(figures);
    updates.describe(figures);
    figures.lines_overlong = vigil.overlong();
    figures.silent = vigil.robotIsSilent();
    figures.record_revision = book.record().revision;
    figures.behavior_running = behavior_running;
    figures.recording = records.figures();
    figures.replay = replay.figures();
    return figures;
}

bool RobotSession::Private::refusedInReplay() {
    if (replaying() && !notices.stands(Topic::Replay))
        notices.trouble(Severity::Warning, Topic::Replay,
                        "This is a replay of the past, so nothing can be sent. Connect to a server and "
                        "spawn a robot to drive one.");
    return replaying();
}

void RobotSession::Private::noteFault(const std::string& sentence) {
    book.noteFault(sentence);
    records.noteFault(sentence);
    notices.say(Severity::Warning, Topic::Fault, sentence);
}

void RobotSession::Private::endReplay() {
    if (!replaying())
        return;
    notices.mute(false);
    updates.mute(false);
    book.passOn(false);
    behavior_running = false;
    replay.end();
    records.forgetFaults(); // Those of the replay.
    notices.forget(Topic::Replay);
}

void RobotSession::Private::adjustReplay() {
    if (!replaying() || !book.adjustPart())
        return;
    touched();
    QTimer::singleShot(0, &q, [this] { adjustReplay(); });
}

void RobotSession::Private::replayRewound() {
    beginConnection();
    incoming.rewind();
    book.rewind();
    book.setAdjust(false); // Until the recording tells its mission.
    helm.rewind();
    vigil.rewind();
    behavior_running = false;
    updates.rewind();
    touched();
}

void RobotSession::Private::replayBegan(std::optional<double> cell_size_m, const std::string& level) {
    book.beginReplay(cell_size_m, level);
}

void RobotSession::Private::replayClosed(bool lost) {
    behavior_running = false;
    if (!lost)
        return;
    spawning.end();
    helm.loseConnection();
}

void RobotSession::Private::replayLine(std::string_view text, LineNumber number) {
    incoming.continueAfter({number.value - 1});
    takeLine(text);
}

void RobotSession::Private::replayCommand(const agent::CausedCommand& command, std::string text, LineNumber after) {
    helm.sawSent(command.command);
    book.takeSent(command.command);
    if (const auto* asked = std::get_if<protocol::Init>(&command.command))
        spawning.sawInit(*asked);
    updates.addCommand(command, std::move(text), after, incoming.now());
}

/// A mission that cannot be read says nothing about its map, which then stays as it was flown.
void RobotSession::Private::replayMission(std::string_view note) {
    const auto flown = readFlownMission(note, {});
    book.setAdjust(flown && flown->mission.adjust);
}

void RobotSession::Private::replayTask(const ReplayedTask& task, const std::string& robot_name) {
    book.beginTask(task.behavior_id, robot_name, task.area_in_map);
    behavior_running = true;
    updates.addTask(task);
}

void RobotSession::Private::replaySeeks(bool on) {
    book.passOn(on);
    if (!on)
        adjustReplay();
    notices.mute(on);
    updates.mute(on);
}

} // namespace usar::mission
