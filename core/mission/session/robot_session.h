// One robot from connect to close: the agent life cycle of the thesis (3), the same in the window and headless.
#pragma once

#include <memory>
#include <string>

#include <QObject>

#include "core/agent/running_behavior.h"
#include "core/link/tcp_link.h"
#include "core/mapping/height_map.h"
#include "core/mission/claims/claim_watch.h"
#include "core/mission/files/scan_record.h"
#include "core/mission/session/earlier_scan.h"
#include "core/mission/session/session_orders.h"
#include "core/mission/session/session_update.h"

namespace usar::mission {

/// Link, reader, modules, behavior and height map of one robot. Runs in a session thread; slots are called by queued
/// connection or from that thread; results leave by value in signals. After connecting it asks for start poses; INIT is
/// sent once per connection; after a reconnect the robot is spawned again only on request, while map, marks and line
/// numbers continue. Stop, close and a finished behavior send the behavior's safe command first. If lockstep was
/// requested and the server has agreed, it answers every STA with the behavior's commands and then STEP.
class RobotSession : public QObject {
    Q_OBJECT
public:
    explicit RobotSession(double cell_size_m = 0.25, QObject* parent = nullptr);
    ~RobotSession() override;

    /// To be called before `open`.
    void setLimits(const SessionLimits& limits);
    /// Lets `open` connect in memory; see TcpLink::useInProcess.
    void useInProcess(link::InProcessServer server);
    /// What the user can do on this server about a robot that lacks sensors, in sentences; a warning repeats it when a
    /// behavior could not begin for that. Empty: nothing is said.
    void setEquipmentAdvice(const std::string& advice);

    /// For headless use in the same thread; `snapshot` and `figures` are computed by each call. Only `snapshot` fills
    /// the raster.
    const ScanRecord& record() const;
    ScanRecord snapshot(bool with_scans = false) const; ///< see ScanBook
    SessionFigures figures() const;
    const mapping::HeightMap& map() const;
    /// Adjusts the map with everything that was scanned; takes up to some seconds, so it is for headless use.
    void finishMap();
    const link::LinkStatus& linkStatus() const;

    /// The behavior is stopped as soon as these claims are decided; to be called before it starts.
    void setClaims(std::vector<Claim> claims, CountContacts count_contacts);
    /// Judges what is not judged yet as if the flight were over.
    const ClaimWatch& endClaims();
    /// `timeReached` is emitted once, after the first line at or after this time on the protocol clock.
    void awaitTime(Seconds when);

    /// Records every byte from now on, with its time and cause, in a new file (resources/docs/recording-format.md),
    /// until `stopRecording` or the end of the session. `facts` are stored with it. Problems are also notices with the
    /// topic "recording"; the session continues.
    Result<void> startRecording(const QString& path, const RecordingFacts& facts);

public slots:
    void open(const QString& host, quint16 port, bool lockstep);
    void close();
    /// Refused with a notice while the connection has a robot. After a failed spawn the session reconnects first,
    /// because a server accepts one INIT per connection; after a lost connection it may be called once a new one is
    /// there. The progress is in `figures().spawn`.
    void spawn(const usar::mission::SpawnRequest& request);
    /// `mission_note`: what it flies, for the recording (core/mission/files/flown_mission.h); empty: unknown.
    void startBehavior(std::shared_ptr<usar::agent::RunningBehavior> host, const usar::agent::Task& task,
                       const std::string& mission_note = {});
    /// The behavior that is started next continues this scan: see ScanBook::continueScan.
    void continueScan(std::shared_ptr<const usar::mission::EarlierScan> earlier);
    void order(usar::agent::Order order);
    void setParameters(const usar::agent::ParameterSet& parameters);
    /// Controls the plan of the behavior; without a behavior it only refuses a new plan. While a plan is halted, a
    /// server in lockstep gets no STEP, so its time waits.
    void control(const usar::agent::PlanControl& control);
    /// Sends the safe command at once; the behavior ends as stopped by the user, and control by hand ends.
    void stop();
    /// The user drives from now on: a running behavior is paused, and its DRIVEs are dropped. Ends with
    /// `giveControlBack`, when a behavior starts or is resumed, and with stop, close or a lost connection.
    void takeControl();
    void giveControlBack();
    /// Drives until the device is released or silent for `SessionLimits::hand`, or the robot falls silent; all of these
    /// send a zero DRIVE at once. Ignored without control. The result is in `figures().control`.
    void drive(const usar::mission::HandIntent& intent);
    /// Ends the hold but not the control; `reason` is a part of a sentence.
    void stopDriving(const QString& reason);
    void sendCommand(const usar::protocol::Command& command, const usar::by::Source& source);
    /// Whether the map is adjusted at landings and at the end, see ScanBook::setAdjust.
    void setAdjust(bool on);
    void adjustAtEachLanding(bool on); ///< see ScanBook::adjustAtEachLanding
    /// Whether it is also adjusted in flight, see ScanBook::adjustInFlight.
    void adjustInFlight(bool on);
    /// Replaces SessionLimits::flight, for this behavior and later ones.
    void setFlightLimit(Seconds limit);
    /// Whether scans are kept for exports of points, see ScanBook::keepScans; to be called before the first scan.
    void keepScans(bool on);
    /// Emits `recordReady` with a copy of everything that was scanned, for the export pool, once an adjustment of the
    /// map that is under way is done.
    void requestRecord();
    /// The same with `mapReady`. `with_scans`: see ScanBook::snapshot.
    void requestMap(bool with_scans);
    /// Cell size of the height map, 0.02 .. 10 m. Refused with a notice once the map has heights.
    void setCellSize(double cell_size_m);
    /// `expected`: the server's time is stopped on purpose, so silence is not reported.
    void expectSilence(bool expected);
    /// Notes that something was made to fail, or works again; kept in the record, the recording and the messages.
    void noteFault(const std::string& sentence);

    void setRecordingLimit(usar::mission::RecordingLimit limit_bytes); ///< see RecordKeeping::setLimit
    void stopRecording();
    /// `recordingFlushed` follows once everything up to now is in the file. The recording continues.
    void flushRecording();

    /// Replaces `open`: the lines come from a recording, paused at its beginning, and are processed like live ones.
    /// Nothing can be sent. `replayOpened` or `replayFailed` follows.
    void openRecording(const QString& path);
    void orderReplay(const usar::mission::ReplayOrder& order);

signals:
    /// `complaint` is a sentence about what is missing from the file, or empty.
    void replayOpened(const usar::mission::RecordingFacts& facts, const QString& complaint);
    void replayFailed(const QString& reason);
    /// `path` is the file, or empty if nothing is recorded.
    void recordingFlushed(const QString& path);
    void timeReached(); ///< see awaitTime
    /// The last record has been played.
    void replayEnded();
    void linkChanged(const usar::link::LinkStatus& status);
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    void spawned(const QString& robot_name);
    /// Also reported as a notice: silence after INIT, or the server closed the connection. After silence data may still
    /// come (a paused simulator); then `spawned` follows.
    void spawnFailed(const QString& reason);
    /// `broke`: the behavior failed by itself; it may be started again.
    void behaviorFinished(bool success, const QString& reason, bool broke);
    /// At most one every 16 ms; costs nothing while nobody is connected to this signal.
    void updated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void recordReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void mapReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void noticed(const usar::mission::Notice& notice);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

} // namespace usar::mission
