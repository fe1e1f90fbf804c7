#include "core/mission/session/robot_session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QTimer>

#include "core/link/across_threads.h"
#include "core/mission/files/result_writer.h"
#include "core/mission/session/robot_session_private.h"
#include "core/protocol/command_writer.h"

namespace usar::mission {

RobotSession::RobotSession(double cell_size_m, QObject* parent)
    : QObject(parent)
    , d_(std::make_unique<Private>(*this, cell_size_m)) {}

RobotSession::~RobotSession() {
    disconnect();
    d_->helm.makeSafe(by::Session{"close"});
    d_->link.disconnect(this);
}

void RobotSession::useInProcess(link::InProcessServer server) {
    d_->link.useInProcess(std::move(server));
}

void RobotSession::setLimits(const SessionLimits& limits) {
    d_->limits = limits;
    d_->link.setLimits(limits.link);
    d_->vigil.setLimits(limits);
    d_->helm.setLimits(limits);
    const Seconds shortest = std::min({limits.greeting, limits.spawn, limits.stale});
    d_->watch_timer.setInterval(std::max(toMilliseconds(shortest) / 8, std::chrono::milliseconds(5)));
}

void RobotSession::setEquipmentAdvice(const std::string& advice) {
    d_->equipment_advice = advice;
}

const ScanRecord& RobotSession::record() const {
    return d_->book.record();
}

ScanRecord RobotSession::snapshot(bool with_scans) const {
    return d_->book.snapshot(with_scans);
}

SessionFigures RobotSession::figures() const {
    return d_->figures();
}

const mapping::HeightMap& RobotSession::map() const {
    return d_->book.mapper().map();
}

const link::LinkStatus& RobotSession::linkStatus() const {
    return d_->linkStatus();
}

void RobotSession::open(const QString& host, quint16 port, bool lockstep) {
    const link::LinkStatus before = d_->link.status();
    close();
    if (host.trimmed() != before.host || port != before.port)
        d_->records.forgetFaults(); // Another simulator has others.
    d_->lockstep_wanted = lockstep;
    d_->link.open(host, port);
}

void RobotSession::close() {
    d_->endReplay();
    d_->helm.endControl("the connection is closed");
    d_->helm.stopBehavior(by::Session{"close"}, "The connection was closed.");
    d_->spawning.end();
    d_->spawning.dropWaiting();
    d_->notices.endAll();
    d_->link.close();
}

void RobotSession::spawn(const SpawnRequest& request) {
    if (!d_->refusedInReplay())
        d_->spawning.ask(request, d_->connected(), d_->wall());
}

void RobotSession::startBehavior(std::shared_ptr<agent::RunningBehavior> host, const agent::Task& task,
                                 const std::string& mission_note) {
    if (d_->refusedInReplay())
        return;
    if (!d_->spawning.done()) {
        d_->notices.trouble(Severity::Warning, Topic::NoRobot, "There is no robot to fly. Spawn one first.");
        return;
    }
    d_->helm.endControl("the behavior " + host->behaviorId() + " took over");
    if (d_->helm.hasBehavior())
        d_->helm.stopBehavior(by::Session{"another behavior"}, "Another behavior was started.");
    d_->book.beginTask(host->behaviorId(), task.robot_name, task.area_in_map);
    d_->records.noteMission(mission_note);
    d_->records.noteTask(d_->book.record());
    d_->behavior_running = true;
    d_->behavior_since = d_->incoming.now();
    d_->helm.start(std::move(host));
    d_->touched();
}

void RobotSession::continueScan(std::shared_ptr<const EarlierScan> earlier) {
    if (d_->refusedInReplay())
        return;
    d_->book.continueScan(*earlier);
    d_->touched();
}

void RobotSession::order(agent::Order order) {
    d_->helm.order(order);
}

void RobotSession::control(const agent::PlanControl& control) {
    d_->helm.control(control);
}

void RobotSession::setParameters(const agent::ParameterSet& parameters) {
    d_->helm.setParameters(parameters);
}

void RobotSession::stop() {
    d_->helm.endControl("stopped by the operator");
    d_->helm.stopBehavior(by::Operator{"stop"}, "Stopped by the operator.");
    d_->touched();
}

void RobotSession::takeControl() {
    if (d_->refusedInReplay())
        return;
    if (!d_->spawning.done() || d_->spawning.isStation())
        return d_->notices.trouble(Severity::Warning, Topic::NoRobot, "There is no robot to drive. Spawn one first.");
    d_->helm.takeControl();
}

void RobotSession::giveControlBack() {
    d_->helm.endControl("control was given back");
}

void RobotSession::drive(const HandIntent& intent) {
    if (!d_->replaying())
        d_->helm.drive(intent);
}

void RobotSession::stopDriving(const QString& reason) {
    d_->helm.endHold(reason.toStdString());
}

void RobotSession::sendCommand(const protocol::Command& command, const by::Source& source) {
    if (d_->refusedInReplay())
        return;
    if (d_->connected())
        d_->helm.sendForUser(command, source);
    else if (!d_->notices.stands(Topic::NoConnection)) // Once, however often an input device sends.
        d_->notices.trouble(Severity::Warning, Topic::NoConnection,
                            "There is no connection to send " + protocol::write(command) + " on. Connect first.");
}

void RobotSession::requestRecord() {
    if (d_->book.adjustPart()) { // In parts, so that lines and orders are taken in between.
        QTimer::singleShot(0, this, &RobotSession::requestRecord);
        return;
    }
    d_->touched();
    const auto record = std::make_shared<const ScanRecord>(snapshot());
    if (const std::string notice = farPartsNotice(*record); !notice.empty())
        d_->notices.say(Severity::Warning, Topic::FarParts, notice);
    emit recordReady(record);
}

void RobotSession::requestMap(bool with_scans) {
    if (d_->book.adjustPart()) {
        QTimer::singleShot(0, this, [this, with_scans] { requestMap(with_scans); });
        return;
    }
    emit mapReady(std::make_shared<const ScanRecord>(snapshot(with_scans)));
}

void RobotSession::setFlightLimit(Seconds limit) {
    d_->limits.flight = limit;
}

void RobotSession::setAdjust(bool on) {
    d_->book.setAdjust(on);
}

void RobotSession::adjustAtEachLanding(bool on) {
    d_->book.adjustAtEachLanding(on);
}

void RobotSession::adjustInFlight(bool on) {
    d_->book.adjustInFlight(on);
}

void RobotSession::keepScans(bool on) {
    d_->book.keepScans(on);
}

void RobotSession::finishMap() {
    d_->book.finishAdjustment();
}

void RobotSession::setCellSize(double cell_size_m) {
    d_->book.setCellSize(cell_size_m);
}

void RobotSession::expectSilence(bool expected) {
    d_->vigil.expectSilence(expected, d_->wall());
}

void RobotSession::noteFault(const std::string& sentence) {
    d_->noteFault(sentence);
}

void RobotSession::setClaims(std::vector<Claim> claims, CountContacts count_contacts) {
    d_->claims = ClaimWatch(std::move(claims), std::move(count_contacts));
}

const ClaimWatch& RobotSession::endClaims() {
    d_->claims.end();
    return d_->claims;
}

void RobotSession::awaitTime(Seconds when) {
    d_->awaited = when;
}

Result<void> RobotSession::startRecording(const QString& path, const RecordingFacts& facts) {
    stopRecording();
    Result<void> begun;
    if (d_->replaying())
        begun = failure("a replay cannot be recorded", path.toStdString(), "It has a file already");
    else
        begun = d_->records.begin(path, facts);
    if (begun)
        d_->notices.over(Topic::Recording);
    else
        d_->notices.trouble(Severity::Error, Topic::Recording, begun.error().text());
    d_->touched();
    return begun;
}

void RobotSession::setRecordingLimit(RecordingLimit limit_bytes) {
    d_->records.setLimit(limit_bytes);
    d_->touched();
}

void RobotSession::stopRecording() {
    d_->records.end();
    d_->touched();
}

void RobotSession::flushRecording() {
    const QString path = d_->records.path();
    if (path.isEmpty())
        return emit recordingFlushed({});
    // Called in the recorder's thread, which ends before this object does.
    d_->records.flush([this, path] { link::post(this, [this, path] { emit recordingFlushed(path); }); });
}

void RobotSession::openRecording(const QString& path) {
    close();
    auto recording = link::RecordingReader::open(path, link::OpenMode::Quick);
    if (!recording) {
        emit replayFailed(QString::fromStdString(recording.error().text()));
        return;
    }
    const link::RecordingSurvey survey = (*recording)->survey();
    d_->replay.begin(*std::move(recording));
    emit replayOpened(survey.facts, QString::fromStdString(survey.complaint()));
    d_->touched();
}

void RobotSession::orderReplay(const ReplayOrder& order) {
    d_->replay.order(order);
}

} // namespace usar::mission
