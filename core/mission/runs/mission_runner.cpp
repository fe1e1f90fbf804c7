#include "core/mission/runs/mission_runner.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QTimer>

#include "core/agent/behavior_start.h"
#include "core/mission/files/mission_check.h"
#include "core/mission/files/result_writer.h"

namespace usar::mission {

namespace {

constexpr char robot_name[] = "R1";
constexpr std::chrono::milliseconds progress_period{200};

enum class Phase { Idle, Connecting, Spawning, Flying, Over };

Seconds elapsedOn(const QElapsedTimer& timer) {
    return Seconds(timer.isValid() ? static_cast<double>(timer.nsecsElapsed()) * 1e-9 : 0.0);
}

} // namespace

struct MissionRunner::Private {
    Private(MissionRunner& runner, Mission mission_, const agent::PluginLoader& plugins_, RunOptions options_);

    Result<void> prepare();
    void takeStartPoses(const protocol::StartPoses& poses);
    void takeRobot();
    void look();
    Seconds flightTime() const;
    Progress progress() const;
    void conclude(bool success, const std::string& reason, int exit_code);
    RunSummary figuresOf(const ScanRecord& record);
    Result<QStringList> save(const ScanRecord& record, const RunSummary& figures);

    MissionRunner& q;
    Mission mission;
    const agent::PluginLoader& plugins;
    RunOptions options;
    RobotSession session;
    QTimer timer;
    QElapsedTimer since_start;
    QElapsedTimer since_spawn;
    QElapsedTimer since_flight;
    QElapsedTimer since_time_moved;
    std::optional<PreparedBehavior> behavior;
    Pose start_in_map;
    Seconds last_now{-1.0};
    Phase phase = Phase::Idle;
    QJsonObject summary;
};

MissionRunner::Private::Private(MissionRunner& runner, Mission mission_, const agent::PluginLoader& plugins_,
                                RunOptions options_)
    : q(runner)
    , mission(std::move(mission_))
    , plugins(plugins_)
    , options(std::move(options_))
    , session(mission.cell_size_m, &runner)
    , timer(&runner) {
    if (options.result_folder.isEmpty())
        options.result_folder = defaultResultFolder();
    session.setLimits(options.limits.session);
    timer.setInterval(progress_period);
    connect(&timer, &QTimer::timeout, &q, [this] { look(); });
    connect(&session, &RobotSession::noticed, &q, &MissionRunner::noticed);
    connect(&session, &RobotSession::startPosesKnown, &q,
            [this](const protocol::StartPoses& poses) { takeStartPoses(poses); });
    connect(&session, &RobotSession::spawned, &q, [this] { takeRobot(); });
    connect(&session, &RobotSession::spawnFailed, &q,
            [this](const QString& reason) { conclude(false, reason.toStdString(), MissionFailed); });
    connect(&session, &RobotSession::behaviorFinished, &q, [this](bool success, const QString& reason) {
        conclude(success, reason.toStdString(), success ? Done : MissionFailed);
    });
}

Result<void> MissionRunner::Private::prepare() {
    auto prepared = prepareBehavior(mission, plugins);
    if (!prepared)
        return tl::unexpected(prepared.error());
    behavior = *std::move(prepared);
    if (options.world_extent)
        if (auto inside = checkAreaInside(mission, *options.world_extent); !inside)
            return inside;
    if (auto writable = checkFolderIsWritable(options.result_folder); !writable || options.recording.isEmpty())
        return writable;
    const QSignalBlocker quiet(session); // The error is reported once, as the reason.
    return session.startRecording(options.recording, {{"robot", robot_name},
                                                      {"class", mission.robot_class},
                                                      {"mission", mission.name},
                                                      {"program", "usar-mission"}});
}

void MissionRunner::Private::takeStartPoses(const protocol::StartPoses& poses) {
    if (phase != Phase::Connecting)
        return;
    const auto pose = startPoseOf(mission, poses);
    if (!pose) {
        conclude(false, pose.error().text(), BadInput);
        return;
    }
    phase = Phase::Spawning;
    since_spawn.start();
    start_in_map = *pose;
    session.spawn({mission.robot_class, robot_name, start_in_map});
}

void MissionRunner::Private::takeRobot() {
    if (phase != Phase::Spawning)
        return;
    const agent::Task task{robot_name, start_in_map, mission.area_in_map};
    const auto made = agent::startBehavior(plugins, mission.behavior, {task, behavior->parameters, behavior->plan},
                                           mission.isolate ? std::optional(options.behavior_host) : std::nullopt);
    if (!made) {
        conclude(false, made.error().text(), BadInput);
        return;
    }
    phase = Phase::Flying;
    since_flight.start();
    session.startBehavior(*made, task);
}

void MissionRunner::Private::look() {
    const SessionFigures figures = session.figures();
    if (std::exchange(last_now, figures.now) != figures.now || !since_time_moved.isValid())
        since_time_moved.start();
    if (phase == Phase::Connecting && elapsedOn(since_start) > options.limits.connect) {
        const std::string trouble = session.linkStatus().trouble.toStdString();
        conclude(false,
                 trouble.empty() ? "The server sent no start poses. Is it USARSim, and is its game running?" : trouble,
                 BadInput);
    } else if (phase == Phase::Spawning && elapsedOn(since_spawn) > options.limits.spawn) {
        conclude(false,
                 "The robot did not appear. Is the start pose free, and does the server know " + mission.robot_class +
                     "?",
                 MissionFailed);
    } else if (phase == Phase::Flying && elapsedOn(since_time_moved) > options.limits.stall) {
        conclude(false, "The simulation's clock has stood still too long. Is it paused, or has the server hung?",
                 MissionFailed);
    } else if (phase == Phase::Flying && flightTime() > options.limits.flight) {
        conclude(false, "The mission took longer than a mission is allowed to. Make the area smaller.", MissionFailed);
    }
    if (phase != Phase::Over)
        emit q.progressed(progress());
}

/// Time since the spawn, on the protocol clock.
Seconds MissionRunner::Private::flightTime() const {
    const SessionFigures figures = session.figures();
    return since_flight.isValid() && figures.spawned_at.count() > 0.0 ? figures.now - figures.spawned_at : Seconds{0.0};
}

Progress MissionRunner::Private::progress() const {
    const agent::BehaviorStatus& status = session.record().status;
    const Seconds now = session.figures().now;
    const double wall_s = elapsedOn(since_flight).count();
    Progress result;
    result.percent = status.progress_pct.value_or(0.0);
    result.now = now;
    result.time_left = status.time_left;
    switch (phase) {
    case Phase::Flying:
        result.state = status.state;
        result.speed_x = wall_s > 0.0 ? flightTime().count() / wall_s : 0.0;
        break;
    case Phase::Spawning:
        result.state = "spawning";
        break;
    default:
        result.state = session.linkStatus().reason.isEmpty() ? "connecting" : session.linkStatus().reason.toStdString();
    }
    return result;
}

void MissionRunner::Private::conclude(bool success, const std::string& reason, int exit_code) {
    if (phase == Phase::Flying)
        emit q.progressed(progress()); // The final progress, even if the flight was shorter than the timer's period.
    if (std::exchange(phase, Phase::Over) == Phase::Over)
        return;
    timer.stop();
    QCoreApplication::sendPostedEvents(&q, QEvent::MetaCall); // The fault that ended the run may still be queued.
    const ScanRecord record = session.snapshot();
    RunSummary figures = figuresOf(record);
    figures.success = success;
    figures.reason = reason;
    session.close();
    if (auto files = save(record, figures)) {
        figures.files = *std::move(files);
    } else {
        figures.success = false;
        figures.reason += " " + files.error().text();
        exit_code = std::max<int>(exit_code, MissionFailed);
    }
    summary = toJson(figures);
    QMetaObject::invokeMethod(
        &q, [this, exit_code] { emit q.finished(exit_code); }, Qt::QueuedConnection);
}

RunSummary MissionRunner::Private::figuresOf(const ScanRecord& record) {
    const bool flew = since_flight.isValid();
    RunSummary figures;
    figures.mission = mission.name;
    figures.behavior = mission.behavior;
    figures.plan = mission.plan;
    figures.seed = options.seed;
    figures.duration = flightTime();
    figures.wall = elapsedOn(since_flight);
    figures.truth = flew && options.true_figures ? options.true_figures() : std::nullopt;
    addSession(figures, session.figures());
    addRecord(figures, record, options.truth ? &*options.truth : nullptr);
    return figures;
}

/// Writes the results. If that fails, because the disk has filled up since the check, the scan is saved to the folder
/// for temporary files instead.
Result<QStringList> MissionRunner::Private::save(const ScanRecord& record, const RunSummary& figures) {
    if (record.raster.empty())
        return QStringList{};
    if (const std::string notice = farPartsNotice(record); !notice.empty())
        emit q.noticed({Severity::Warning, notice});
    const QJsonObject json = toJson(figures);
    auto files = writeResults(record, json, options.result_folder);
    if (files)
        return files;
    const QString shelter = QDir::tempPath() + "/USAR_Scan";
    emit q.noticed({Severity::Error, files.error().text() + " Trying " + shelter.toStdString() + " instead."});
    return writeResults(record, json, shelter);
}

MissionRunner::MissionRunner(Mission mission, const agent::PluginLoader& plugins, RunOptions options, QObject* parent)
    : QObject(parent)
    , d_(std::make_unique<Private>(*this, std::move(mission), plugins, std::move(options))) {}

MissionRunner::~MissionRunner() {
    d_->session.disconnect(this);
}

void MissionRunner::start() {
    d_->since_start.start();
    if (const auto prepared = d_->prepare(); !prepared) {
        d_->conclude(false, prepared.error().text(), BadInput);
        return;
    }
    d_->phase = Phase::Connecting;
    d_->timer.start();
    d_->session.open(d_->options.host, d_->options.port, d_->options.lockstep);
}

void MissionRunner::noteFault(const QString& sentence) {
    d_->session.noteFault(sentence.toStdString());
}

void MissionRunner::interrupt() {
    if (d_->phase != Phase::Over)
        d_->conclude(false, "Interrupted; what was scanned until then is kept.", MissionFailed);
}

const QJsonObject& MissionRunner::summary() const {
    return d_->summary;
}

RunSummary refusedRun(const Error& error, const MissionOptions* options, const Mission* mission) {
    RunSummary known;
    known.reason = error.text();
    if (options) {
        known.behavior = options->behavior.toStdString();
        known.seed = options->seed;
    }
    if (mission) {
        known.mission = mission->name;
        known.behavior = mission->behavior;
        known.plan = mission->plan;
    }
    return known;
}

} // namespace usar::mission
