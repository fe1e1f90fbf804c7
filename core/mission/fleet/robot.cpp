#include "core/mission/fleet/robot.h"

#include <span>
#include <utility>

#include "core/base/alternatives.h"
#include "core/base/numbers.h"
#include "core/link/across_threads.h"
#include "core/mapping/area_cells.h"
#include "core/mission/files/mission_check.h"

namespace usar::mission {

namespace {

int connections_made = 0; // Used in the GUI thread only, where all robots are made.

} // namespace

Robot::Robot() : thread_(new QThread), session_(new RobotSession(RobotView{}.cell_size_m)) {
    view_.connection = {++connections_made};
    thread_->setObjectName("robot");
    session_->keepScans(true); // Whoever sees a map may want its points.
    session_->moveToThread(thread_);
    connect(thread_, &QThread::finished, session_, &QObject::deleteLater);
    connectSession();
    thread_->start();
}

Robot::~Robot() {
    dropWaitingStart();
    link::post(session_, [session = session_] {
        session->close();
        session->thread()->quit();
    });
    if (thread_->wait(2000))
        delete thread_;
}

void Robot::connectSession() {
    link::connectAcross(session_, &RobotSession::linkChanged, this, [this](const link::LinkStatus& status) {
        view_.link = status;
        emit linkChanged();
    });
    link::connectAcross(session_, &RobotSession::startPosesKnown, this, &Robot::startPosesKnown);
    link::connectAcross(session_, &RobotSession::updated, this, [this](const auto& update) {
        take(*update);
        emit updated(update);
    });
    link::connectAcross(session_, &RobotSession::behaviorFinished, this,
                        [this](bool success, const QString& reason, bool broke) {
                            took_ = wallTime();
                            view_.broke = broke;
                            view_.finished = agent::BehaviorFinished{success, reason.toStdString()};
                            view_.figures.behavior_running = view_.paused = false;
                            view_.halted.reset();
                            emit behaviorFinished(success, reason);
                        });
    link::connectAcross(session_, &RobotSession::recordReady, this, &Robot::recordReady);
    link::connectAcross(session_, &RobotSession::mapReady, this, &Robot::mapReady);
    link::connectAcross(session_, &RobotSession::noticed, this, &Robot::noticed);
    link::connectAcross(session_, &RobotSession::recordingFlushed, this, &Robot::recordingFlushed);
    link::connectAcross(session_, &RobotSession::replayOpened, this, &Robot::replayOpened);
    link::connectAcross(session_, &RobotSession::replayFailed, this, &Robot::replayFailed);
    connect(session_, &RobotSession::spawned, session_, [waiting = waiting_start_] {
        if (const auto begin = std::exchange(*waiting, nullptr))
            begin();
    });
    connect(session_, &RobotSession::spawnFailed, session_, [waiting = waiting_start_] { *waiting = nullptr; });
}

void Robot::dropWaitingStart() {
    link::post(session_, [waiting = waiting_start_] { *waiting = nullptr; });
}

void Robot::open(const QString& host, quint16 port, bool lockstep, const QString& equipment_advice) {
    dropWaitingStart();
    link::post(session_,
               [session = session_, advice = equipment_advice.toStdString()] { session->setEquipmentAdvice(advice); });
    call(&RobotSession::open, host, port, lockstep);
}

void Robot::close() {
    dropWaitingStart();
    call(&RobotSession::close);
}

void Robot::stop() {
    dropWaitingStart();
    call(&RobotSession::stop);
}

void Robot::spawn(RobotId id, const SpawnRequest& request) {
    view_.id = id;
    view_.spawn = request;
    call(&RobotSession::spawn, request);
}

Result<void> Robot::startBehavior(const agent::PluginLoader& plugins, const StartedBehavior& start,
                                  const CheckedStart& checked, const QString& host_program,
                                  const std::string& mission_note) {
    const agent::ParameterSet& parameters = checked.parameters;
    const agent::Task task{view_.spawn.robot_name, view_.spawn.start_in_map, start.area_in_map, checked.dry_above_m};
    agent::Task flown = task; // The record keeps the whole area, of which the coverage is counted.
    flown.area_in_map = areaWithin(task.area_in_map, checked.world_in_map);
    const auto behavior = agent::startBehavior(plugins, start.id, {flown, parameters, start.plan},
                                               start.isolated ? std::optional(host_program) : std::nullopt);
    if (!behavior)
        return tl::unexpected(behavior.error());
    // All in one call, so that the behavior does nothing before its breakpoints are set.
    const auto begin = [session = session_, task, host = *behavior, breakpoints = breakpoints_, mission_note,
                        earlier = start.continues] {
        if (earlier)
            session->continueScan({earlier, &earlier->scan});
        session->startBehavior(host, task, mission_note);
        session->control(breakpoints);
    };
    link::post(session_, [session = session_, waiting = waiting_start_, begin] {
        *waiting = nullptr; // The new start takes the place of one that still waits.
        if (session->figures().spawn == SpawnState::Asked)
            *waiting = begin;
        else
            begin();
    });
    started_ = start;
    started_->parameters = parameters.values();
    asked_plan_.reset();
    since_start_.start();
    took_.reset();
    view_.broke = false;
    beginTask(start.id, start.continues ? start.continues->flown.mission.area_in_map : start.area_in_map);
    return {};
}

/// Shows a behavior that begins, here or in a replay.
void Robot::beginTask(const std::string& behavior_id, const Rectangle& area_in_map) {
    view_.behavior_id = behavior_id;
    view_.area_in_map = area_in_map;
    view_.paused = false;
    view_.halted.reset();
    view_.finished.reset();
    view_.status.reset();
    view_.zones.reset();
    countCovered();
}

void Robot::setTaskOptions(const Mission& mission) {
    if (view_.cell_size_m != mission.cell_size_m)
        call(&RobotSession::setCellSize, mission.cell_size_m);
    if (view_.tiles.empty())
        view_.cell_size_m = mission.cell_size_m;
    view_.adjust = mission.adjust;
    view_.limit_h = mission.limit_h;
    call(&RobotSession::setAdjust, mission.adjust);
    call(&RobotSession::adjustAtEachLanding, true); // Somebody may be watching.
    call(&RobotSession::adjustInFlight, true);
    call(&RobotSession::setFlightLimit, limitFrom(mission.limit_h));
}

void Robot::order(agent::Order order) {
    view_.paused = order == agent::Order::Pause;
    pause_confirmed_ = false;
    call(&RobotSession::order, order);
}

void Robot::setParameters(const agent::ParameterSet& parameters) {
    if (started_)
        started_->parameters = parameters.values();
    call(&RobotSession::setParameters, parameters);
}

void Robot::control(const agent::PlanControl& control) {
    if (const auto* const breakpoints = std::get_if<agent::SetBreakpoints>(&control))
        breakpoints_ = *breakpoints;
    if (const auto* const replace = std::get_if<agent::ReplacePlan>(&control))
        asked_plan_ = replace->plan;
    call(&RobotSession::control, control);
}

void Robot::takeControl() {
    if (running() && !view_.halted) {
        view_.paused = true;
        pause_confirmed_ = false;
    }
    call(&RobotSession::takeControl);
}

void Robot::openRecording(const QString& path, ConnectionId looks_back_on) {
    view_.recording = path;
    view_.looks_back_on = looks_back_on;
    call(&RobotSession::adjustAtEachLanding, true);
    call(&RobotSession::openRecording, path);
}

void Robot::becomeReplay(RobotId id, const QString& robot_name, const RecordingFacts& facts) {
    view_.id = id;
    view_.spawn.robot_name = robot_name.toStdString();
    if (const auto found = facts.find("robot"); found != facts.end())
        view_.recorded_name = found->second;
    if (const auto found = facts.find("class"); found != facts.end())
        view_.spawn.class_name = found->second;
    if (const auto found = facts.find("cell_size_m"); found != facts.end())
        view_.cell_size_m = readNumber(found->second).value_or(view_.cell_size_m);
}

/// Resets the view, because a replay was rewound: what was shown until now has not happened yet.
void Robot::forget() {
    RobotView fresh;
    static_cast<RobotIdentity&>(fresh) = view_;
    view_ = std::move(fresh);
}

void Robot::take(const SessionUpdate& update) {
    if (update.rewound)
        forget();
    const std::span<const agent::Published> published(update.published);
    for (const agent::Published& value : published.first(update.published_before_task))
        take(value);
    if (update.task)
        beginTask(update.task->behavior_id, update.task->area_in_map);
    view_.figures = update.figures;
    for (const agent::Published& value : published.subspan(update.published_before_task))
        take(value);
    for (const auto& tile : update.tiles) {
        view_.tiles[tile->index] = tile;
        countCovered(*tile);
    }
    if (!update.tiles.empty() && !isReplay())
        view_.unsaved = true;
    view_.corrected_path_m = update.corrected_path_m;
    if (update.height_range)
        view_.height_range = update.height_range;
    if (update.ground)
        view_.ground = update.ground;
    for (const protocol::InfoLine& line : update.lines) {
        view_.equipment.take(line);
        // Until a behavior publishes its estimate, the robot's INS gives its place on the map.
        if (const auto* ins = std::get_if<protocol::InsReading>(&line.message); ins && !view_.status)
            view_.base_in_map = ins->base_in_map;
    }
}

/// Counts again, for another area or map.
void Robot::countCovered() {
    view_.covered_cells.clear();
    for (const auto& [index, tile] : view_.tiles)
        countCovered(*tile);
}

void Robot::countCovered(const mapping::HeightTile& tile) {
    view_.covered_cells[tile.index] =
        mapping::knownCellsIn(mapping::cellsOf(view_.area_in_map, view_.cell_size_m), tile);
}

std::optional<double> Robot::coverage_pct() const {
    if (view_.area_in_map.empty())
        return std::nullopt;
    double covered = 0.0;
    for (const auto& [index, cells] : view_.covered_cells)
        covered += cells;
    const std::int64_t all = mapping::cellsOf(view_.area_in_map, view_.cell_size_m).count();
    return all == 0 ? 0.0 : 100.0 * covered / double(all);
}

std::optional<double> Robot::batteryLeft_pct() const {
    if (view_.status && view_.status->battery_used_pct)
        return 100.0 - *view_.status->battery_used_pct;
    return view_.figures.battery_left_pct;
}

Seconds Robot::wallTime() const {
    return took_ ? *took_ : Seconds(since_start_.isValid() ? double(since_start_.nsecsElapsed()) * 1e-9 : 0.0);
}

void Robot::take(const agent::Published& published) {
    std::visit(Overloaded{[this](const agent::BehaviorStatus& status) {
                              view_.status = status;
                              view_.equipment.take(status);
                              view_.paused = view_.paused && (status.paused || !pause_confirmed_);
                              pause_confirmed_ = status.paused;
                          },
                          [this](const agent::PoseEstimate& estimate) {
                              view_.base_in_map = estimate.base_in_map;
                              const Vec2 point_m = estimate.base_in_map.position_m.head<2>();
                              if (view_.trail_m.empty() || (view_.trail_m.back() - point_m).norm() > 0.2)
                                  view_.trail_m.push_back(point_m);
                          },
                          [this](const agent::MapMark& mark) { view_.marks.push_back(mark); },
                          [this](const agent::SonarZones& zones) { view_.zones = zones; },
                          [this](const agent::PlannedPath& path) { view_.planned_m = path.points_in_map_m; },
                          [this](const agent::CurrentGoal& goal) { view_.goal_m = goal.goal_in_map_m; },
                          [this](const agent::BehaviorFinished& finished) {
                              view_.finished = finished;
                              view_.figures_at_end = view_.figures;
                              view_.halted.reset();
                          },
                          [this](const agent::PlanHalted& halted) { view_.halted = halted; },
                          [this](const agent::PlanResumed&) { view_.halted.reset(); },
                          [this](const agent::PlanReplaced& replaced) {
                              const auto asked = std::exchange(asked_plan_, {});
                              if (started_ && asked && replaced.fate != agent::PlanFate::Refused)
                                  started_->plan = asked;
                          },
                          [](const auto&) {}},
               published);
}

} // namespace usar::mission
