#include "core/mission/runs/mission_runner.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>

#include "core/agent/behavior_start.h"
#include "core/base/numbers.h"
#include "core/mapping/area_cells.h"
#include "core/mission/files/result_writer.h"
#include "core/mission/session/notices.h"

namespace usar::mission {

namespace {

constexpr char robot_name[] = "R1";
constexpr std::chrono::milliseconds progress_period{200};

Seconds elapsedOn(const QElapsedTimer& timer) {
    return Seconds(timer.isValid() ? static_cast<double>(timer.nsecsElapsed()) * 1e-9 : 0.0);
}

} // namespace

MissionRunner::MissionRunner(Mission mission, const agent::PluginLoader& plugins, RunOptions options)
    : mission_(std::move(mission))
    , plugins_(plugins)
    , options_(std::move(options))
    , session_(mission_.cell_size_m, this)
    , after_stop_(session_, [this] { return options_.true_figures(); }) {
    if (options_.result_folder.isEmpty())
        options_.result_folder = defaultResultFolder();
    session_.setLimits(options_.limits.session);
    session_.setEquipmentAdvice(options_.equipment_advice);
    session_.setAdjust(mission_.adjust);
    session_.keepScans(needPoints(options_.formats));
    timer_.setInterval(progress_period);
    connect(&timer_, &QTimer::timeout, this, &MissionRunner::look);
    connect(&session_, &RobotSession::noticed, this, &MissionRunner::noticed);
    connect(&session_, &RobotSession::noticed, this, [this](const Notice& notice) {
        if (notice.topic == textOf(Topic::Recording) && notice.severity == Severity::Error)
            unwritten_ << QString::fromStdString(notice.text);
    });
    connect(&after_stop_, &AfterStop::over, this, &MissionRunner::finish);
    connect(&session_, &RobotSession::startPosesKnown, this, &MissionRunner::takeStartPoses);
    connect(&session_, &RobotSession::spawned, this, &MissionRunner::takeRobot);
    connect(&session_, &RobotSession::spawnFailed, this,
            [this](const QString& reason) { conclude(false, reason.toStdString(), MissionFailed); });
    connect(&session_, &RobotSession::behaviorFinished, this, [this](bool success, const QString& reason) {
        conclude(success, reason.toStdString(), success ? Done : MissionFailed);
    });
}

MissionRunner::~MissionRunner() {
    session_.disconnect(this);
}

void MissionRunner::start() {
    since_start_.start();
    session_.setClaims(mission_.claims, [this]() -> std::optional<int> {
        const auto truth = options_.true_figures ? options_.true_figures() : std::nullopt;
        return truth ? std::optional(truth->collisions) : std::nullopt;
    });
    if (const auto prepared = prepare(); !prepared)
        return conclude(false, prepared.error().text(), BadInput);
    if (options_.earlier)
        continueEarlier();
    if (phase_ == Phase::Over)
        return;
    phase_ = Phase::Connecting;
    timer_.start();
    if (options_.in_process)
        session_.useInProcess(options_.in_process);
    session_.open(options_.host, options_.port, options_.lockstep);
}

void MissionRunner::continueEarlier() {
    const RecordedScan& earlier = *options_.earlier;
    session_.continueScan({options_.earlier, &earlier.scan});
    if (areaWithin(earlier.rest_in_map, options_.world_extent.value_or(Rectangle{})).empty())
        conclude(true, "Nothing was left to fly: the recording has scanned the whole area.", Done);
}

std::string MissionRunner::missionNote() const {
    FlownMission flown{mission_, options_.seed, {}};
    if (options_.earlier)
        flown.continues = options_.earlier->scan.run.recording;
    if (mission_.preset.empty())
        return noteOf(flown);
    flown.mission.preset.clear(); // A later version may mean something else by it.
    flown.mission.parameters = behavior_->parameters.values();
    return noteOf(flown, plugins_.behavior(mission_.behavior)->parameters);
}

void MissionRunner::interrupt() {
    if (phase_ != Phase::Over)
        conclude(false, interrupted_reason, MissionFailed);
}

void MissionRunner::robotVanished(const QString& name) {
    if (phase_ != Phase::Over && name == robot_name)
        conclude(false,
                 "The simulator has removed the robot " + name.toStdString() + "; what was scanned until then is kept.",
                 MissionFailed);
}

void MissionRunner::robotSilenced(const QString& name) {
    if (phase_ != Phase::Over && name == robot_name)
        conclude(false,
                 "The server has fallen silent, though the connection stands; what was scanned until then is kept.",
                 MissionFailed);
}

Result<void> MissionRunner::prepare() {
    auto prepared = prepareBehavior(mission_, plugins_);
    if (!prepared)
        return tl::unexpected(prepared.error());
    behavior_ = *std::move(prepared);
    const Rectangle world_in_map = options_.world_extent.value_or(Rectangle{});
    if (auto inside = checkAreaInWorld(mission_, world_in_map); !inside)
        return inside;
    if (const std::string notice = beyondWorldNotice(mission_.area_in_map, world_in_map); !notice.empty())
        emit noticed({Severity::Warning, notice});
    if (auto writable = checkFolderIsWritable(options_.result_folder); !writable || options_.recording.isEmpty())
        return writable;
    session_.setRecordingLimit(options_.recording_limit);
    const QSignalBlocker quiet(session_); // The error is reported once, as the reason.
    return session_.startRecording(options_.recording, {{"robot", robot_name},
                                                        {"class", mission_.robot_class},
                                                        {"mission", mission_.name},
                                                        {"program", "usar-mission"}});
}

void MissionRunner::takeStartPoses(const protocol::StartPoses& poses) {
    if (phase_ != Phase::Connecting)
        return;
    const bool as_before = options_.earlier && options_.earlier->start_in_map;
    const auto pose = as_before ? Result<Pose>(*options_.earlier->start_in_map) : startPoseOf(mission_, poses);
    if (!pose)
        return conclude(false, pose.error().text(), BadInput);
    phase_ = Phase::Spawning;
    since_spawn_.start();
    start_in_map_ = *pose;
    session_.spawn({mission_.robot_class, robot_name, start_in_map_});
}

void MissionRunner::takeRobot() {
    if (phase_ != Phase::Spawning)
        return;
    const agent::Task task{robot_name, start_in_map_,
                           options_.earlier ? options_.earlier->rest_in_map : mission_.area_in_map,
                           options_.dry_above_m};
    agent::Task flown = task; // The record keeps the whole area, of which the coverage is counted.
    flown.area_in_map = areaWithin(task.area_in_map, options_.world_extent.value_or(Rectangle{}));
    const auto made = agent::startBehavior(plugins_, mission_.behavior, {flown, behavior_->parameters, behavior_->plan},
                                           mission_.isolate ? std::optional(options_.behavior_host) : std::nullopt,
                                           options_.behavior_thread);
    if (!made)
        return conclude(false, made.error().text(), BadInput);
    phase_ = Phase::Flying;
    since_flight_.start();
    session_.startBehavior(*made, task, missionNote());
}

void MissionRunner::look() {
    const SessionFigures figures = session_.figures();
    if (std::exchange(last_now_, figures.now) != figures.now || !since_time_moved_.isValid())
        since_time_moved_.start();
    if (phase_ == Phase::Connecting && elapsedOn(since_start_) > options_.limits.connect) {
        const std::string trouble = session_.linkStatus().trouble.toStdString();
        conclude(false,
                 trouble.empty() ? "The server sent no start poses. Is it USARSim, and is its game running?" : trouble,
                 BadInput);
    } else if (phase_ == Phase::Spawning && elapsedOn(since_spawn_) > options_.limits.spawn) {
        conclude(false,
                 "The robot did not appear. Is the start pose free, and does the server know " + mission_.robot_class +
                     "?",
                 MissionFailed);
    } else if (phase_ >= Phase::Flying && elapsedOn(since_time_moved_) > options_.limits.stall) {
        conclude(false, "The simulation's clock has stood still too long. Is it paused, or has the server hung?",
                 MissionFailed);
    }
    if (phase_ < Phase::Watching)
        emit progressed(progress());
}

Seconds MissionRunner::flightTime() const {
    const SessionFigures figures = session_.figures();
    return since_flight_.isValid() && figures.spawned_at.count() > 0.0 ? figures.now - figures.spawned_at
                                                                       : Seconds{0.0};
}

Progress MissionRunner::progress() const {
    const agent::BehaviorStatus& status = session_.record().status;
    const Seconds now = session_.figures().now;
    const double wall_s = elapsedOn(since_flight_).count();
    Progress result;
    result.percent = status.progress_pct.value_or(0.0);
    result.now = now;
    result.time_left = status.time_left;
    result.time_left_range = status.time_left_range;
    if (phase_ == Phase::Flying) {
        result.state = status.state;
        result.speed_x = wall_s > 0.0 ? flightTime().count() / wall_s : 0.0;
        result.coverage_pct = mapping::coverage_pct(session_.map(), session_.record().area_in_map);
        result.distance_m = status.distance_flown_m;
        result.elapsed = flightTime();
        result.range_left_m = status.range_left_m;
    } else if (phase_ == Phase::Spawning) {
        result.state = "spawning";
    } else {
        const std::string reason = session_.linkStatus().reason.toStdString();
        result.state = reason.empty() ? "connecting" : reason;
    }
    return result;
}

void MissionRunner::conclude(bool success, const std::string& reason, int exit_code) {
    if (phase_ == Phase::Flying)
        emit progressed(progress()); // The final progress, even if the flight was shorter than the timer's period.
    if (phase_ == Phase::Watching)
        after_stop_.giveUp();
    if (phase_ >= Phase::Watching)
        return;
    phase_ = Phase::Watching;
    QCoreApplication::sendPostedEvents(this, QEvent::MetaCall); // The fault that ended the run may still be queued.
    session_.finishMap();
    record_ = session_.snapshot(needPoints(options_.formats));
    figures_ = figuresOf(record_);
    figures_.success = success;
    figures_.reason = reason;
    exit_code_ = exit_code;
    judgeDamage(figures_);
    judgeClaims(figures_);
    if (!after_stop_.begin(figures_.truth))
        return finish();
    session_.stopRecording(); // What follows is no part of the mission.
}

void MissionRunner::finish() {
    phase_ = Phase::Over;
    timer_.stop();
    if (figures_.truth)
        after_stop_.addTo(*figures_.truth);
    if (figures_.claims.empty())
        judgeDamage(figures_);
    for (const QString& warning : figures_.warnings)
        emit noticed({Severity::Warning, warning.toStdString()});
    if (exit_code_ != BadInput)
        exit_code_ = figures_.success ? Done : MissionFailed;
    session_.close();
    if (auto files = save(record_, figures_)) {
        figures_.files = *std::move(files);
    } else {
        figures_.success = false;
        figures_.reason += " " + files.error().text();
        exit_code_ = std::max<int>(exit_code_, MissionFailed);
    }
    record_ = {};
    summary_ = toJson(figures_);
    if (!unwritten_.isEmpty())
        summary_["unwritten"] = QJsonArray::fromStringList(unwritten_);
    QMetaObject::invokeMethod(
        this, [this] { emit finished(exit_code_); }, Qt::QueuedConnection);
}

/// A mission with claims is judged by them alone: it is stopped as soon as they are decided.
void MissionRunner::judgeClaims(RunSummary& figures) {
    if (mission_.claims.empty())
        return;
    const ClaimWatch& claims = session_.endClaims();
    figures.claims = claims.verdicts();
    figures.success = claims.allHold();
    if (figures.reason != claims.sentence())
        figures.reason = claims.sentence() + ' ' + figures.reason;
}

RunSummary MissionRunner::figuresOf(const ScanRecord& record) {
    const bool flew = since_flight_.isValid();
    RunSummary figures;
    figures.mission = mission_.name;
    figures.behavior = mission_.behavior;
    figures.plan = mission_.plan;
    figures.seed = options_.seed;
    figures.duration = flightTime();
    figures.wall = elapsedOn(since_flight_);
    figures.truth = flew && options_.true_figures ? options_.true_figures() : std::nullopt;
    addSession(figures, session_.figures());
    const auto flight = behavior_ ? flightLimitsOf(start_in_map_, behavior_->parameters.values()) : std::nullopt;
    addRecord(figures, record, options_.truth ? &*options_.truth : nullptr, flight);
    if (options_.course)
        figures.course = courseOf(record, figures.score.coverage_pct);
    return figures;
}

Result<QStringList> MissionRunner::save(const ScanRecord& record, const RunSummary& figures) {
    const bool wanted =
        options_.files == ResultFiles::Always || (options_.files == ResultFiles::IfFailed && !figures.success);
    if (record.raster.empty() || !wanted)
        return QStringList{};
    if (const std::string notice = farPartsNotice(record); !notice.empty())
        emit noticed({Severity::Warning, notice});
    const QJsonObject json = toJson(figures);
    const auto points = checkPoints(options_.formats, record);
    if (!points)
        emit noticed({Severity::Warning, points.error().text()});
    const FormatList formats = points ? options_.formats : withoutPoints(options_.formats);
    const auto writeInto = [&](const QString& folder) { return writeResults(record, json, folder, {}, {}, formats); };
    auto files = writeInto(options_.result_folder);
    if (files)
        return files;
    unwritten_ << QString::fromStdString(files.error().text());
    const QString shelter = QDir::tempPath() + shelter_name;
    emit noticed({Severity::Error, files.error().text() + " Trying " + shelter.toStdString() + " instead."});
    return writeInto(shelter);
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
