#include "core/mission/session/robot_session.h"

#include <algorithm>
#include <utility>

#include "core/base/numbers.h"
#include "core/mapping/raster_export.h"
#include "core/mission/files/result_writer.h"
#include "core/mission/session/robot_session_private.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

RobotSession::RobotSession(double cell_size_m, QObject* parent)
    : QObject(parent)
    , d_(std::make_unique<Private>(*this, cell_size_m)) {}

RobotSession::~RobotSession() {
    disconnect();
    d_->makeSafe("session: close");
    d_->link.disconnect(this);
}

void RobotSession::setLimits(const SessionLimits& limits) {
    d_->limits = limits;
    d_->link.setLimits(limits.link);
    d_->sensors = SensorWatch(limits.sensor_silence);
    const Seconds shortest = std::min({limits.greeting, limits.spawn, limits.stale});
    d_->watch_timer.setInterval(std::max(toMilliseconds(shortest) / 8, std::chrono::milliseconds(5)));
}

const ScanRecord& RobotSession::record() const {
    return d_->record;
}

ScanRecord RobotSession::snapshot() const {
    ScanRecord copy = d_->record;
    copy.raster.cell_size_m = d_->mapper.map().cellSize_m();
    copy.far_rasters = mapping::rastersOf(d_->mapper.map());
    if (!copy.far_rasters.empty()) {
        copy.raster = std::move(copy.far_rasters.front());
        copy.far_rasters.erase(copy.far_rasters.begin());
    }
    copy.cells_left_out = d_->mapper.map().knownCellCount() - knownCellCount(copy);
    return copy;
}

const SessionFigures& RobotSession::figures() const {
    d_->countTraffic();
    d_->showControl();
    return d_->figures;
}

const link::LinkStatus& RobotSession::linkStatus() const {
    return d_->linkStatus();
}

void RobotSession::open(const QString& host, quint16 port, bool lockstep) {
    close();
    d_->lockstep_wanted = lockstep;
    d_->link.open(host, port);
}

void RobotSession::close() {
    d_->endReplay();
    d_->endHand("the connection is closed");
    d_->stopBehavior("session: close", "The connection was closed.");
    d_->setSpawn(SpawnState::None);
    d_->after_reconnect.reset();
    d_->endTroubles(true);
    d_->link.close();
}

void RobotSession::spawn(const SpawnRequest& request) {
    if (d_->refusedInReplay())
        return;
    if (!d_->connected()) {
        d_->trouble(Severity::Warning, "no connection",
                    "There is no connection to spawn " + request.robot_name + " on. Connect first.");
    } else if (d_->figures.spawn == SpawnState::None) {
        d_->init(request);
    } else if (d_->figures.spawn == SpawnState::Failed) {
        const link::LinkStatus status = d_->link.status();
        d_->after_reconnect = request;
        d_->link.open(status.host, status.port);
    } else {
        d_->say(Severity::Warning, "second robot",
                d_->request.robot_name + (d_->figures.spawned ? " is" : " is being") +
                    " spawned here already, and a connection carries one robot. Reconnect to spawn another.");
    }
}

void RobotSession::startBehavior(std::shared_ptr<agent::RunningBehavior> host, const agent::Task& task) {
    if (d_->refusedInReplay())
        return;
    if (!d_->figures.spawned) {
        d_->trouble(Severity::Warning, "no robot", "There is no robot to fly. Spawn one first.");
        return;
    }
    d_->endHand("the behavior " + host->behaviorId() + " took over");
    if (d_->host)
        d_->stopBehavior("session: another behavior", "Another behavior was started.");
    d_->record.robot_name = task.robot_name;
    d_->record.behavior_id = host->behaviorId();
    d_->record.area_in_map = task.area_in_map;
    d_->record.status = {};
    d_->host = std::move(host);
    d_->figures.behavior_running = true;
    d_->noteTask();
    d_->host->setPatience(d_->figures.lockstep ? d_->limits.behavior_lockstep : d_->limits.behavior);
    agent::RunningBehavior::Output output = d_->host->begin();
    if (d_->host->endHandle() >= 0) {
        d_->end_watch = std::make_unique<QSocketNotifier>(d_->host->endHandle(), QSocketNotifier::Read);
        connect(d_->end_watch.get(), &QSocketNotifier::activated, this, [this] { d_->behaviorEnded(); });
    }
    d_->takeOutput(output, false);
    d_->touched();
}

void RobotSession::order(agent::Order order) {
    if (!d_->host)
        return;
    if (order != agent::Order::Pause)
        d_->endHand("the behavior " + d_->host->behaviorId() + " took over");
    agent::RunningBehavior::Output output = d_->host->order(order);
    d_->takeOutput(output, false);
    d_->sendDrive(false);
    d_->stepOwed();
    d_->link.flush();
    d_->touched();
}

void RobotSession::control(const agent::PlanControl& control) {
    if (!d_->host) {
        if (const auto* const asked = std::get_if<agent::ReplacePlan>(&control))
            d_->takePublished({agent::PlanReplaced{
                .fate = agent::PlanFate::Refused, .plan_name = asked->plan.name, .reason = "No behavior runs."}});
        return d_->touched();
    }
    const bool was_halted = d_->host->halted();
    agent::RunningBehavior::Output output = d_->host->control(control);
    d_->takeOutput(output, false);
    d_->sendDrive(was_halted); // At the same protocol time as the safe command before it.
    d_->stepOwed();
    d_->link.flush();
    d_->touched();
}

void RobotSession::setParameters(const agent::ParameterSet& parameters) {
    if (!d_->host)
        return;
    d_->host->setParameters(parameters);
    if (agent::RunningBehavior::Output nothing; d_->host->ending())
        d_->takeOutput(nothing, false);
}

void RobotSession::stop() {
    d_->endHand("stopped by the operator");
    d_->stopBehavior("operator: stop", "Stopped by the operator.");
    d_->touched();
}

void RobotSession::sendCommand(const protocol::Command& command, const std::string& source) {
    if (d_->refusedInReplay())
        return;
    if (!d_->connected()) {
        if (!d_->troubles.contains("no connection")) // Once, however often an input device sends.
            d_->trouble(Severity::Warning, "no connection",
                        "There is no connection to send " + protocol::write(command) + " on. Connect first.");
        return;
    }
    d_->send({command, {source, d_->state->line()}});
    d_->sendDrive(false);
    d_->link.flush();
    d_->touched();
}

void RobotSession::requestRecord() {
    const auto record = std::make_shared<const ScanRecord>(snapshot());
    if (const std::string notice = farPartsNotice(*record); !notice.empty())
        d_->say(Severity::Warning, "far parts", notice);
    emit recordReady(record);
}

void RobotSession::setCellSize(double cell_size_m) {
    if (d_->mapper.map().cellSize_m() == cell_size_m)
        return;
    if (d_->mapper.map().tileCount() == 0)
        return d_->mapper.clearMap(cell_size_m);
    d_->say(Severity::Warning, "cell size",
            "The height map keeps its cells of " + fixed(d_->mapper.map().cellSize_m(), 2) +
                " m, for it has heights already. Remove the robot and spawn it anew to map with cells of " +
                fixed(cell_size_m, 2) + " m.");
}

void RobotSession::expectSilence(bool expected) {
    if (d_->silence_expected && !expected && d_->since_data.isValid())
        d_->since_data.start(); // The silence until now was not the robot's.
    d_->silence_expected = expected;
}

void RobotSession::noteFault(const std::string& sentence) {
    d_->record.faults.push_back(sentence);
    d_->noteForRecording("fault", sentence);
    d_->say(Severity::Warning, "fault", sentence);
}

void RobotSession::clearRecord() {
    d_->mapper.clearMap();
    d_->record.marks.clear();
    d_->record.path_m.clear();
    d_->record.status = {};
}

} // namespace usar::mission
