// The steps of a session's life: connection, lines, behavior, commands.
#include "core/mission/robot_session_private.h"

#include <utility>

#include <QMetaMethod>

#include "core/mission/stream_name.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

namespace {

constexpr std::chrono::milliseconds frame{16};

} // namespace

RobotSession::Private::Private(RobotSession& session, double cell_size_m)
    : q(session)
    , link(&session)
    , frame_timer(&session)
    , watch_timer(&session)
    , sensors(limits.sensor_silence)
    , mapper(cell_size_m) {
    frame_timer.setSingleShot(true);
    frame_timer.setInterval(frame);
    watch_timer.setInterval(toMilliseconds(limits.stale) / 8);
    link.setLineTaker([this](std::string_view text) { takeLine(text); });
    connect(&link, &link::TcpLink::statusChanged, &q, &RobotSession::linkChanged);
    connect(&link, &link::TcpLink::opened, &q, [this] { opened(); });
    connect(&link, &link::TcpLink::closed, &q, [this] { closed(); });
    connect(&frame_timer, &QTimer::timeout, &q, [this] { emitFrame(); });
    connect(&watch_timer, &QTimer::timeout, &q, [this] { watch(); });
}

void RobotSession::Private::opened() {
    state.emplace();
    sensors.reset();
    gate.reset();
    mapper.forgetScans();
    spawn = SpawnState::None;
    start_poses_settled = silence_said = false;
    figures.spawned = figures.lockstep = false;
    figures.now = figures.spawned_at = Seconds{0.0};
    if (lockstep_wanted)
        write(protocol::Lockstep{});
    write(protocol::GetStartPoses{});
    over("no connection");
    over("link", "The connection is back. Spawn " + request.robot_name + " again to go on.");
    since_opened.start();
    watch_timer.start();
    if (after_reconnect)
        init(*std::exchange(after_reconnect, std::nullopt));
    link.flush();
}

void RobotSession::Private::closed() {
    watch_timer.stop();
    const bool lost_robot = std::exchange(figures.spawned, false);
    spawn = SpawnState::None;
    figures.lockstep = false;
    endTroubles(false);
    if (lost_robot)
        trouble(Severity::Warning, "link",
                "The connection is lost, and " + request.robot_name +
                    " with it. What was scanned is kept; spawn the robot again when connected.");
    if (host)
        finishBehavior(false, QStringLiteral("The connection to the server was lost."));
    touched();
}

void RobotSession::Private::takeLine(std::string_view text) {
    protocol::InfoLine line = reader.read(text);
    ++figures.lines_received;
    state->take(line);
    figures.now = state->now();
    if (auto complaint = complaints.take(line))
        say(Severity::Warning, std::move(complaint->topic), std::move(complaint->text));
    figures.lines_malformed = complaints.count();
    noteMessage(line);
    if (figures.spawned && figures.spawned_at.count() == 0.0)
        figures.spawned_at = figures.now; // zero still when a sensor speaks before the first STA
    agent::BehaviorHost::Output output;
    if (host)
        output = host->receive(line);
    takeOutput(output, std::holds_alternative<protocol::RobotState>(line.message));
    if (observed)
        collector.addLine(std::move(line));
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
    // A robot that was never asked for speaks on a proxy that shares connections; it is nobody's spawn.
    if (spawn != SpawnState::Asked && spawn != SpawnState::Failed)
        return;
    spawn = SpawnState::Done;
    figures.spawned = true;
    over("no robot");
    over("spawn", request.robot_name + " has spawned after all.");
    emit q.spawned(QString::fromStdString(request.robot_name));
}

/// Commands go out before the results are worked in, so that the simulator computes its next tick meanwhile; not so
/// for the last tick, where whoever hears the end must find time standing still.
void RobotSession::Private::takeOutput(agent::BehaviorHost::Output& output, bool is_tick) {
    const bool finishing = host && host->finished();
    for (agent::CausedCommand& command : output.commands)
        send(command);
    if (is_tick && !finishing)
        endTick();
    takePublished(output.published);
    if (is_tick && finishing)
        endTick();
}

void RobotSession::Private::takePublished(const std::vector<agent::Published>& published) {
    if (observed)
        collector.addPublished(published);
    for (const agent::Published& value : published)
        takeValue(value);
}

void RobotSession::Private::takeValue(const agent::Published& value) {
    if (const auto* placement = std::get_if<agent::ScanPlacement>(&value)) {
        if (!mapper.place(*placement) && !std::exchange(unplaced_said, true))
            say(Severity::Warning, "placement",
                "The behavior placed a scan that is too old to be known; it is left out.");
    } else if (const auto* status = std::get_if<agent::BehaviorStatus>(&value)) {
        record.status = *status;
    } else if (const auto* pose = std::get_if<agent::PoseEstimate>(&value)) {
        const Vec3& point_m = pose->base_in_map.position_m;
        if (record.path_m.empty() || (point_m - record.path_m.back()).norm() >= mapper.map().cellSize_m())
            record.path_m.push_back(point_m);
    } else if (const auto* mark = std::get_if<agent::MapMark>(&value)) {
        record.marks.push_back(*mark);
    } else if (const auto* event = std::get_if<agent::BehaviorEvent>(&value)) {
        say(event->severity, "behavior: " + event->text, event->text);
    } else if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value)) {
        makeSafe("session: behavior finished");
        finishBehavior(finished->success, QString::fromStdString(finished->reason));
    }
}

void RobotSession::Private::endTick() {
    sendDrive(false);
    if (figures.lockstep && figures.spawned)
        write(protocol::Step{});
    link.flush();
}

void RobotSession::Private::init(const SpawnRequest& asked) {
    request = asked;
    spawn = SpawnState::Asked;
    since_init.start();
    send({protocol::Init{asked.class_name, asked.robot_name, asked.start_in_map}, {"session: spawn", {}}});
    link.flush();
}

void RobotSession::Private::stopBehavior(const std::string& source, const QString& reason) {
    makeSafe(source);
    if (host)
        finishBehavior(false, reason);
}

void RobotSession::Private::finishBehavior(bool success, const QString& reason) {
    host.reset();
    figures.behavior_running = false;
    emit q.behaviorFinished(success, reason);
}

void RobotSession::Private::makeSafe(const std::string& source) {
    if (!figures.spawned)
        return;
    gate.reset();
    const bool rolls = state->latest() && state->latest()->kind == protocol::VehicleKind::Ground;
    if (host)
        send(host->safeCommand(source));
    else if (rolls)
        send({protocol::SkidDrive{}, {source, state->line()}});
    else
        send({protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}, {source, state->line()}});
    sendDrive(true);
    link.flush();
}

void RobotSession::Private::send(const agent::CausedCommand& command) {
    if (DriveGate::isDrive(command.command)) {
        gate.offer(command);
        return;
    }
    write(command.command);
    if (observed)
        collector.addCommand(command);
}

void RobotSession::Private::sendDrive(bool at_once) {
    const auto drive = at_once ? gate.releaseNow(figures.now) : gate.release(figures.now);
    if (!drive)
        return;
    write(drive->command);
    if (observed)
        collector.addCommand(*drive);
}

void RobotSession::Private::write(const protocol::Command& command) {
    link.send(protocol::write(command));
}

void RobotSession::Private::say(Severity severity, std::string topic, std::string text) {
    emit q.noticed({.severity = severity, .text = std::move(text), .topic = std::move(topic)});
}

void RobotSession::Private::trouble(Severity severity, const std::string& topic, std::string text) {
    troubles.insert(topic);
    say(severity, topic, std::move(text));
}

void RobotSession::Private::over(const std::string& topic, std::string text) {
    if (troubles.erase(topic) > 0)
        emit q.noticed({.severity = Severity::Note, .text = std::move(text), .topic = topic, .over = true});
}

/// A lost connection ends what was wrong on it, but not that it is lost nor that the robot would not spawn; that there
/// is none ends only with a new one.
void RobotSession::Private::endTroubles(bool all) {
    for (const std::string& topic : std::set(troubles))
        if (topic != "no connection" && (all || (topic != "link" && topic != "spawn")))
            over(topic);
}

void RobotSession::Private::touched() {
    if (frame_timer.isActive())
        return;
    observed = q.isSignalConnected(QMetaMethod::fromSignal(&RobotSession::updated));
    if (observed)
        frame_timer.start();
}

void RobotSession::Private::emitFrame() {
    emit q.updated(collector.take(mapper, figures));
}

} // namespace usar::mission
