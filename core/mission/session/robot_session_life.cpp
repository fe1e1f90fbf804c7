// The life cycle of a session: connection, lines, behavior, commands.
#include "core/mission/session/robot_session_private.h"

#include <algorithm>
#include <utility>

#include <QMetaMethod>

#include "core/mission/session/stream_name.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/zero_drives.h"

namespace usar::mission {

namespace {

constexpr std::chrono::milliseconds frame{16};

} // namespace

RobotSession::Private::Private(RobotSession& session, double cell_size_m)
    : q(session)
    , link(&session)
    , frame_timer(&session)
    , watch_timer(&session)
    , recording_timer(&session)
    , hand_timer(&session)
    , sensors(limits.sensor_silence)
    , mapper(cell_size_m) {
    frame_timer.setSingleShot(true);
    frame_timer.setInterval(frame);
    watch_timer.setInterval(toMilliseconds(limits.stale) / 8);
    link.setLineTaker([this](std::string_view text) { takeLine(text); });
    connect(&link, &link::TcpLink::statusChanged, &q, &RobotSession::linkChanged);
    connect(&link, &link::TcpLink::opened, &q, [this] { opened(); });
    connect(&link, &link::TcpLink::closed, &q, [this] {
        if (recorder)
            recorder->write({.kind = link::RecordKind::Closed,
                             .line = {figures.lines_received},
                             .bytes = link.status().trouble.toStdString()});
        connectionLost();
    });
    link.setByteTaker([this](std::string_view bytes) {
        if (recorder)
            recorder->write({.kind = link::RecordKind::In, .line = {figures.lines_received}, .bytes = bytes});
    });
    connect(&frame_timer, &QTimer::timeout, &q, [this] { emitFrame(); });
    connect(&watch_timer, &QTimer::timeout, &q, [this] { watch(); });
    connect(&recording_timer, &QTimer::timeout, &q, [this] { watchRecording(); });
    setUpHand();
}

void RobotSession::Private::beginConnection() {
    state.emplace();
    sensors.reset();
    gate.reset();
    moving.reset();
    hand.beginConnection();
    dialect = {};
    figures.dialect.reset();
    mapper.forgetScans();
    setSpawn(SpawnState::None);
    start_poses_settled = silence_said = step_held = false;
    figures.lockstep = false;
    figures.now = figures.spawned_at = Seconds{0.0};
    figures.traffic = {};
    complaints_before = complaints.count();
    replay_traffic = {};
    lookForObservers(); // Without this, observers would miss the greeting, which comes before the first frame.
}

void RobotSession::Private::opened() {
    beginConnection();
    if (recorder)
        recorder->write(
            {.kind = link::RecordKind::Opened, .line = {figures.lines_received}, .bytes = placeOf(link.status())});
    if (lockstep_wanted)
        send({protocol::Lockstep{}, {"session: connect", {}}});
    send({protocol::GetStartPoses{}, {"session: connect", {}}});
    over("no connection");
    over("link", "The connection is back. Spawn " + request.robot_name + " again to go on.");
    since_opened.start();
    watch_timer.start();
    if (after_reconnect)
        init(*std::exchange(after_reconnect, std::nullopt));
    link.flush();
}

void RobotSession::Private::connectionLost() {
    watch_timer.stop();
    const SpawnState lost = figures.spawn;
    setSpawn(after_reconnect ? SpawnState::Asked : SpawnState::None);
    figures.lockstep = false;
    endTroubles(false);
    endHand("the connection was lost");
    if (lost == SpawnState::Done)
        trouble(Severity::Warning, "link",
                "The connection is lost, and " + request.robot_name +
                    " with it. What was scanned is kept; spawn the robot again when connected.");
    if (host)
        finishBehavior({false, "The connection to the server was lost."}, false);
    if (lost == SpawnState::Asked && !after_reconnect)
        failSpawn(SpawnState::None, "The server closed the connection before " + request.robot_name +
                                        " said anything. Is the start pose free, and is the server full? Spawn again "
                                        "when connected.");
    touched();
}

void RobotSession::Private::takeLine(std::string_view text) {
    const protocol::InfoLine& line = reader.read(text);
    ++figures.lines_received;
    dialect.take(text);
    figures.dialect = dialect.dialect();
    state->take(line);
    hand.take(line);
    figures.now = state->now();
    if (auto complaint = complaints.take(line))
        say(Severity::Warning, std::move(complaint->topic), std::move(complaint->text));
    figures.lines_malformed = complaints.count();
    if (std::holds_alternative<protocol::GenericMessage>(line.message))
        ++figures.traffic.unknown;
    noteMessage(line);
    if (figures.spawned && figures.spawned_at.count() == 0.0)
        figures.spawned_at = figures.now; // Still zero if a sensor message comes before the first STA.
    agent::RunningBehavior::Output output;
    if (host)
        output = host->receive(line);
    const bool is_tick = std::holds_alternative<protocol::RobotState>(line.message);
    if (observed)
        collector.addLine(line); // First, so that the frame of a finished behavior contains its last line.
    takeOutput(output, is_tick);
    touched();
}

void RobotSession::Private::noteMessage(const protocol::InfoLine& line) {
    if (isRobotData(line.message)) {
        for (const std::string& name : sensors.saw(line.message, figures.now))
            over("sensor: " + name, name + " speaks again.");
        noteData();
    }
    if (const auto* scan = std::get_if<protocol::RangeScan>(&line.message)) {
        mapper.takeScan(*scan, line.number);
    } else if (const auto* configuration = std::get_if<protocol::ConfigurationInfo>(&line.message)) {
        mapper.takeConfiguration(*configuration);
    } else if (const auto* game = std::get_if<protocol::GameInfo>(&line.message)) {
        record.level = game->level;
    } else if (const auto* answer = std::get_if<protocol::LockstepInfo>(&line.message)) {
        figures.lockstep = answer->on;
    } else if (const auto* poses = std::get_if<protocol::StartPoses>(&line.message)) {
        start_poses_settled = true;
        over("start poses", "The start poses came after all.");
        emit q.startPosesKnown(*poses, QString::fromStdString(record.level));
    }
}

void RobotSession::Private::noteData() {
    since_data.start();
    if (std::exchange(silence_said, false))
        over("silence", request.robot_name + " speaks again.");
    // Data of a robot that was not requested comes from a proxy that shares connections; it belongs to no spawn of
    // ours.
    if (figures.spawn != SpawnState::Asked && figures.spawn != SpawnState::Failed)
        return;
    setSpawn(SpawnState::Done);
    over("no robot");
    over("spawn", request.robot_name + " has spawned after all.");
    emit q.spawned(QString::fromStdString(request.robot_name));
}

/// Sends the commands before processing the results, so that the simulator computes its next tick meanwhile. In the
/// last tick it is the other way around: receivers of the end must find the simulator's time standing still.
void RobotSession::Private::takeOutput(agent::RunningBehavior::Output& output, bool is_tick) {
    const bool finishing = host && (host->finished() || host->ending());
    for (agent::CausedCommand& command : output.commands)
        if (!hand.on() || !DriveGate::isDrive(command.command))
            send(command);
    if (host && host->ending()) {
        makeSafe(host->behaviorId() + ": its process has ended");
        output.append(host->takeEnd());
    }
    if (is_tick)
        tickHand();
    if (is_tick && !finishing)
        endTick();
    takePublished(output.published);
    if (is_tick && finishing)
        endTick();
}

void RobotSession::Private::takePublished(const std::vector<agent::Published>& published) {
    if (observed)
        collector.addPublished(published);
    for (const agent::Published& value : published) {
        if (host)
            so_far.take(value);
        notePublished(value);
        takeValue(value);
    }
}

void RobotSession::Private::takeValue(const agent::Published& value) {
    if (const auto* placement = std::get_if<agent::ScanPlacement>(&value)) {
        if (mapper.place(*placement))
            worthSaving();
        else if (!std::exchange(unplaced_said, true))
            say(Severity::Warning, "placement",
                "The behavior placed a scan that is too old to be known; it is left out.");
    } else if (const auto* status = std::get_if<agent::BehaviorStatus>(&value)) {
        const bool news = status->state != record.status.state || status->charges != record.status.charges ||
                          status->distance_flown_m != record.status.distance_flown_m;
        record.status = *status;
        if (news)
            worthSaving();
    } else if (const auto* pose = std::get_if<agent::PoseEstimate>(&value)) {
        const Vec3& point_m = pose->base_in_map.position_m;
        if (record.path_m.empty() || (point_m - record.path_m.back()).norm() >= mapper.map().cellSize_m()) {
            record.path_m.push_back(point_m);
            worthSaving();
        }
    } else if (const auto* mark = std::get_if<agent::MapMark>(&value)) {
        record.marks.push_back(*mark);
        worthSaving();
    } else if (const auto* event = std::get_if<agent::BehaviorEvent>(&value)) {
        say(event->severity, "behavior: " + event->text, event->text);
    } else if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value)) {
        makeSafe("session: behavior finished");
        finishBehavior(*finished, true);
    }
}

void RobotSession::Private::behaviorEnded() {
    agent::RunningBehavior::Output output = host->takeEnd();
    takeOutput(output, false);
    touched();
}

void RobotSession::Private::endTick() {
    if (replayer)
        return;
    sendDrive(false);
    if (figures.lockstep && figures.spawned)
        step();
    link.flush();
}

void RobotSession::Private::step() {
    step_held = host && host->halted();
    if (step_held)
        return;
    write({protocol::Step{}, {"session: lockstep", state->line()}});
    ++figures.steps_sent;
}

void RobotSession::Private::stepOwed() {
    if (!step_held || (host && host->halted()))
        return;
    since_data.start(); // The silence was caused by us.
    step_held = false;
    if (!connected() || !figures.lockstep)
        return;
    step();
    link.flush();
}

Result<protocol::Init> RobotSession::Private::initOf(const SpawnRequest& asked) {
    const auto class_name = protocol::Token::make(asked.class_name);
    const auto robot_name = protocol::Name::make(asked.robot_name);
    if (!class_name || !robot_name)
        return tl::unexpected(class_name ? robot_name.error() : class_name.error());
    return protocol::Init::at(*class_name, *robot_name, asked.start_in_map);
}

void RobotSession::Private::init(const SpawnRequest& asked) {
    request = asked;
    const auto init = initOf(asked);
    if (!init)
        return failSpawn(SpawnState::None, init.error().text());
    setSpawn(SpawnState::Asked);
    since_init.start();
    send({*init, {"session: spawn", {}}});
    link.flush();
    if (protocol::isStation(asked.class_name)) { // A station never announces that it has come.
        setSpawn(SpawnState::Done);
        emit q.spawned(QString::fromStdString(asked.robot_name));
    }
}

void RobotSession::Private::setSpawn(SpawnState now) {
    figures.spawn = now;
    figures.spawned = now == SpawnState::Done;
    touched();
}

void RobotSession::Private::failSpawn(SpawnState now, const std::string& reason) {
    setSpawn(now);
    trouble(Severity::Error, "spawn", reason);
    emit q.spawnFailed(QString::fromStdString(reason));
}

void RobotSession::Private::stopBehavior(const std::string& source, const std::string& reason) {
    makeSafe(source);
    if (host)
        finishBehavior({false, reason}, false);
}

/// Emits a last frame first, so that receivers of the end have the figures that belong to it.
void RobotSession::Private::finishBehavior(const agent::BehaviorFinished& finished, bool is_published) {
    const agent::BehaviorFinished end = finished; // The argument may be a part of what `host` answered.
    if (!is_published)
        noteForRecording("finished", (end.success ? "1 " : "0 ") + end.reason);
    if (end_watch) { // It may be the object that has just signaled the end.
        end_watch->setEnabled(false);
        end_watch.release()->deleteLater();
    }
    const bool broke = host && host->broke();
    host.reset();
    so_far.clear();
    stepOwed();
    figures.behavior_running = false;
    lookForObservers();
    if (observed) {
        if (!is_published)
            collector.addPublished({end});
        frame_timer.stop();
        if (!on_the_way)
            emitFrame();
    }
    if (!replayer)
        emit q.behaviorFinished(end.success, QString::fromStdString(end.reason), broke);
}

void RobotSession::Private::worthSaving() {
    if (mapper.map().range())
        figures.record_revision = ++record.revision;
}

void RobotSession::Private::makeSafe(const std::string& source) {
    if (!figures.spawned || replayer)
        return;
    gate.reset();
    std::optional<protocol::Command> safe;
    if (host) {
        agent::CausedCommand command = host->safeCommand(source);
        safe = command.command;
        send(command);
    }
    for (protocol::Command& stop : stops(safe))
        send({std::move(stop), {source, state->line()}});
    sendDrive(true);
    link.flush();
}

/// Returns a zero DRIVE for the kind of vehicle, unless the behavior has a safe command of its own, and commands that
/// stop everything else that was set in motion.
std::vector<protocol::Command> RobotSession::Private::stops(const std::optional<protocol::Command>& safe) const {
    const auto& latest = state->latest();
    std::vector<protocol::Command> stops;
    if (!safe)
        stops = protocol::zeroDrives(latest ? latest->kind : protocol::VehicleKind::Unknown);
    for (const protocol::Command& stop : moving.stops()) {
        if ((!safe || stop.index() != safe->index()) && std::ranges::find(stops, stop) == stops.end())
            stops.push_back(stop);
    }
    return stops;
}

void RobotSession::Private::send(const agent::CausedCommand& command) {
    if (DriveGate::isDrive(command.command)) {
        figures.traffic.drives_replaced += gate.offer(command);
        return;
    }
    write(command);
}

void RobotSession::Private::sendDrive(bool at_once) {
    if (!at_once && congested())
        return;
    for (const agent::CausedCommand& drive : at_once ? gate.releaseNow(figures.now) : gate.release(figures.now))
        write(drive);
}

void RobotSession::Private::write(const agent::CausedCommand& command) {
    std::string text = protocol::write(command.command, dialect.dialect().value_or(protocol::Dialect::Ut2004));
    dialect.sent(command.command);
    moving.sent(command.command);
    if (recorder && connected())
        recorder->write({.kind = link::RecordKind::Out,
                         .line = {figures.lines_received},
                         .trigger = command.cause.trigger,
                         .name = command.cause.source,
                         .bytes = text + "\r\n"});
    link.send(text);
    if (observed)
        collector.addCommand({command, std::move(text), {figures.lines_received}, figures.now});
}

void RobotSession::Private::countTraffic() {
    protocol::TrafficCounts& traffic = figures.traffic;
    const protocol::TrafficCounts counts = replayer ? replay_traffic : link.counts();
    traffic.lines_in = counts.lines_in;
    traffic.lines_out = counts.lines_out;
    traffic.bytes_in = counts.bytes_in;
    traffic.bytes_out = counts.bytes_out;
    traffic.dropped = counts.dropped;
    traffic.malformed = complaints.count() - complaints_before;
}

void RobotSession::Private::say(Severity severity, std::string topic, std::string text) {
    if (on_the_way)
        return;
    emit q.noticed({.severity = severity, .text = std::move(text), .topic = std::move(topic)});
}

void RobotSession::Private::trouble(Severity severity, const std::string& topic, std::string text) {
    troubles.insert(topic);
    say(severity, topic, std::move(text));
}

void RobotSession::Private::over(const std::string& topic, std::string text) {
    if (troubles.erase(topic) > 0 && !on_the_way)
        emit q.noticed({.severity = Severity::Note, .text = std::move(text), .topic = topic, .over = true});
}

/// Ends troubles. A lost connection ends those that belong to it, but not its loss itself nor a failed spawn; "no
/// connection" ends only with a new one.
void RobotSession::Private::endTroubles(bool all) {
    for (const std::string& topic : std::set(troubles))
        if (topic != "no connection" && (all || (topic != "link" && topic != "spawn")))
            over(topic);
}

void RobotSession::Private::touched() {
    if (frame_timer.isActive() || on_the_way)
        return;
    lookForObservers();
    if (observed)
        frame_timer.start();
}

void RobotSession::Private::lookForObservers() {
    observed = q.isSignalConnected(QMetaMethod::fromSignal(&RobotSession::updated));
}

void RobotSession::Private::emitFrame() {
    countTraffic();
    showControl();
    figures.recording.reset();
    if (recorder)
        figures.recording = {recorder->path(), recorder->elapsed(), recorder->bytes()};
    figures.replay.reset();
    if (replayer)
        figures.replay = replayer->figures();
    emit q.updated(collector.take(mapper, figures));
}

} // namespace usar::mission
