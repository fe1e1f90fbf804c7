// One robot as the window knows it: its session in a thread of its own, and the session's newest values.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QThread>

#include "core/agent/behavior_start.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/own_thread.h"
#include "core/mission/fleet/robot_view.h"
#include "core/mission/session/robot_session.h"

namespace usar::mission {

/// A start passed its checks with these values, which the behavior is given besides the wishes of a person.
struct CheckedStart {
    agent::ParameterSet parameters;
    std::optional<double> dry_above_m; ///< see agent::Task
    /// The robot is sent only to the part of its area that is inside; empty: to all of it.
    Rectangle world_in_map;
};

/// Belongs to the GUI thread, while its RobotSession runs in a thread of its own: calls are queued to that thread and
/// never wait, so their effect shows in a later update. Calls that are not described here do what the session's
/// function of the same name does.
class Robot : public QObject {
    Q_OBJECT
public:
    Robot();
    /// Sends the safe command and closes the connection. Waits at most two seconds for the session's thread, which is
    /// left behind if a plugin hangs in it.
    ~Robot() override;

    const RobotView& view() const { return view_; }
    /// True once `spawn` or `becomeReplay` was called; the server may not have confirmed the robot yet.
    bool spawned() const { return view_.id.valid(); }
    /// Percentage of the mission area whose height is known, 0..100; nullopt without an area.
    std::optional<double> coverage_pct() const;
    /// Remaining battery, 0..100 percent: as the newest behavior told it, else as the robot itself tells it;
    /// nullopt if neither does.
    std::optional<double> batteryLeft_pct() const;
    /// Wall time from the start of the newest behavior to its end, or until now; 0 before the first.
    Seconds wallTime() const;
    /// True while a behavior of ours runs; the one in a replay does not count.
    bool running() const { return view_.figures.behavior_running && !view_.finished && !isReplay(); }
    /// True while a plan of ours is halted.
    bool standsStill() const { return running() && view_.halted; }
    bool isReplay() const { return !view_.recording.isEmpty(); }

    /// `lockstep`: ask the server to wait for our STEP after each tick.
    void open(const QString& host, quint16 port, bool lockstep, const QString& equipment_advice = {});
    void close();
    void spawn(RobotId id, const SpawnRequest& request);
    /// `checked`: what the check of `start` found. `host_program`: runs a behavior that is isolated. Plugins are
    /// third-party code: if one throws or refuses, this returns an error. `mission_note`: see RobotSession. On a robot
    /// that is being spawned the behavior begins with the robot's first line, unless it is stopped, closed or started
    /// again before, or cannot be spawned.
    Result<void> startBehavior(const agent::PluginLoader& plugins, const StartedBehavior& start,
                               const CheckedStart& checked, const QString& host_program,
                               const std::string& mission_note = {});
    /// The newest started behavior; nullopt before the first.
    const std::optional<StartedBehavior>& started() const { return started_; }
    void order(agent::Order order);
    void setParameters(const agent::ParameterSet& parameters);
    /// Controls the plan of the behavior. Breakpoints are also kept for behaviors that start later.
    void control(const agent::PlanControl& control);
    void stop();
    /// `expected`: the server's time is stopped on purpose, so silence is not reported.
    void expectSilence(bool expected) { call(&RobotSession::expectSilence, expected); }
    /// The user drives from now on; a running behavior is paused. See RobotSession.
    void takeControl();
    void giveControlBack() { call(&RobotSession::giveControlBack); }
    void drive(const HandIntent& intent) { call(&RobotSession::drive, intent); }
    void stopDriving(const QString& reason) { call(&RobotSession::stopDriving, reason); }
    void send(const protocol::Command& command, const by::Source& source) {
        call(&RobotSession::sendCommand, command, source);
    }
    void requestRecord() { call(&RobotSession::requestRecord); }
    void requestMap(bool with_scans) { call(&RobotSession::requestMap, with_scans); } ///< `mapReady` follows
    void startRecording(const QString& path, const RecordingFacts& facts) {
        call(&RobotSession::startRecording, path, facts);
    }
    void stopRecording() { call(&RobotSession::stopRecording); }
    /// The limit holds for this recording and later ones.
    void setRecordingLimit(RecordingLimit limit_bytes) { call(&RobotSession::setRecordingLimit, limit_bytes); }
    /// Brings what was recorded to the disk; `recordingFlushed` follows.
    void flushRecording() { call(&RobotSession::flushRecording); }
    /// Takes adjustment, limit and, unless the map has heights, cell size, for the behavior that is started next.
    void setTaskOptions(const Mission& mission);
    void noteFault(const QString& sentence) { call(&RobotSession::noteFault, sentence.toStdString()); }
    /// Replaces `open`; `replayOpened` or `replayFailed` follows. `looks_back_on`: see RobotView.
    void openRecording(const QString& path, ConnectionId looks_back_on = {});
    void orderReplay(const ReplayOrder& order) { call(&RobotSession::orderReplay, order); }
    /// Turns this object into the robot of the opened recording.
    void becomeReplay(RobotId id, const QString& robot_name, const RecordingFacts& facts);
    void markSaved() { view_.unsaved = false; }
    void markUnsaved() { view_.unsaved = true; }

signals:
    void linkChanged();
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    /// Emitted after `view` has taken the update.
    void updated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void behaviorFinished(bool success, const QString& reason);
    /// Answers `requestRecord` with a copy of everything that was scanned.
    void recordReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void mapReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void noticed(const usar::mission::Notice& notice);
    /// `path` is the file, or empty if nothing is recorded.
    void recordingFlushed(const QString& path);
    void replayOpened(const usar::mission::RecordingFacts& facts, const QString& complaint);
    void replayFailed(const QString& reason);

private:
    void connectSession();
    void dropWaitingStart();
    void take(const SessionUpdate& update);
    void take(const agent::Published& published);
    void forget();
    void beginTask(const std::string& behavior_id, const Rectangle& area_in_map);
    void countCovered();
    void countCovered(const mapping::HeightTile& tile);
    template <class Function, class... Arguments>
    void call(Function function, Arguments... arguments) {
        callLater(session_, function, std::move(arguments)...);
    }

    QThread* thread_;       ///< outlives this object only if a plugin hangs in it
    RobotSession* session_; ///< belongs to thread_ and is deleted there
    /// The start of a behavior that waits for its robot, or an empty function. Only the session's thread looks inside.
    std::shared_ptr<std::function<void()>> waiting_start_ = std::make_shared<std::function<void()>>();
    RobotView view_;
    bool pause_confirmed_ = false; ///< the behavior has reported that it is paused
    agent::SetBreakpoints breakpoints_;
    std::optional<StartedBehavior> started_;
    QElapsedTimer since_start_;
    std::optional<Seconds> took_;               ///< wall time of the behavior that has ended
    std::optional<agent::PlanText> asked_plan_; ///< replacement that the running plan has not been exchanged for yet
};

/// The name that the robot was spawned with, as in the protocol, for texts in the window.
inline QString nameOf(const Robot& robot) {
    return QString::fromStdString(robot.view().spawn.robot_name);
}

} // namespace usar::mission
