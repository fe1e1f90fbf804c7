// One robot from connect to close: the agent life cycle of the thesis (3), the same in the window and headless.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include <QObject>

#include "core/agent/running_behavior.h"
#include "core/link/tcp_link.h"
#include "core/mission/scan_record.h"
#include "core/mission/session_update.h"

namespace usar::mission {

/// What is known of a recording besides its records: robot, class, level, host …
using RecordingFacts = std::map<std::string, std::string>;

/// What a person may ask of a replay; several at once where several are set.
struct ReplayOrder {
    std::optional<bool> play{};
    std::optional<double> speed{};       ///< 0.1 to 100, or infinity
    std::optional<Seconds> seek{};       ///< from the recording's beginning
    std::optional<Seconds> seek_by{};    ///< from where it stands, or is on the way to
    std::optional<Seconds> seek_clock{}; ///< by the robot's clock
    bool step = false;                   ///< to the next bytes of the server
};

struct SpawnRequest {
    std::string class_name = "USARBot.AirRobot";
    std::string robot_name = "R1";
    Pose start_in_map;
};

/// How long a session waits before it says that something is missing. Tests shorten them.
struct SessionLimits {
    link::LinkLimits link;
    Seconds greeting{5.0};               ///< wall: no start poses after connect
    Seconds spawn{5.0};                  ///< wall: silence after INIT is a failed spawn (usarsim-protocol 2.4)
    Seconds stale{2.0};                  ///< wall: silence of a spawned robot
    Seconds sensor_silence{3.0};         ///< protocol clock: a sensor that used to speak
    Seconds hand{0.3};                   ///< wall: a hand that holds and says no more is a dead man's
    Seconds behavior{1.0};               ///< wall: an answer of the behavior
    Seconds behavior_lockstep{5.0};      ///< the same where the server's time waits for it
    std::size_t unsent_bytes = 1u << 16; ///< with more in the queue, drives wait and the newest replace older ones
};

/// Link, reader, modules, behavior, height map. Lives in a session thread; all slots are called by queued connection
/// or from that thread; results leave by value in signals. After connect it asks for start poses; INIT is sent once per
/// connection; after a reconnect the robot is spawned anew only by request, while map, marks and line numbers go on.
/// Stop, close and a finished behavior send the behavior's safe command first. Asked for lockstep, it answers every STA
/// with the behavior's commands and then STEP, once the server has agreed.
class RobotSession : public QObject {
    Q_OBJECT
public:
    explicit RobotSession(double cell_size_m = 0.25, QObject* parent = nullptr);
    ~RobotSession() override;

    /// Before `open`.
    void setLimits(const SessionLimits& limits);

    /// For the headless twin, which runs in the same thread. The raster is filled in `snapshot` only.
    const ScanRecord& record() const;
    ScanRecord snapshot() const;
    const SessionFigures& figures() const;
    const link::LinkStatus& linkStatus() const;

    /// Every byte from now on, with its time and cause, into a new file (resources/docs/recording-format.md), until
    /// `stopRecording` or the end of the session. `facts` are kept with it. What goes wrong is a notice of the topic
    /// "recording"; the session goes on.
    Result<void> startRecording(const QString& path, const RecordingFacts& facts);

public slots:
    void open(const QString& host, quint16 port, bool lockstep);
    void close();
    /// Refused with a notice while the connection has a robot. After a spawn that failed the session reconnects first,
    /// for a server takes one INIT per connection; after a lost connection it may be called as soon as there is a new
    /// one. `figures().spawn` says where it stands.
    void spawn(const usar::mission::SpawnRequest& request);
    void startBehavior(std::shared_ptr<usar::agent::RunningBehavior> host, const usar::agent::Task& task);
    void order(usar::agent::Order order);
    void setParameters(const usar::agent::ParameterSet& parameters);
    /// For the plan that decides; nothing without a behavior. Where it stands still, a server in lockstep gets no STEP
    /// and so waits with its time.
    void control(const usar::agent::PlanControl& control);
    /// Safe command at once; the behavior ends as stopped by the person, who gives control back.
    void stop();
    /// The person drives from now on: a behavior that runs is paused, and no DRIVE of its comes through. It ends with
    /// `giveControlBack`, with a behavior that starts or is resumed, and with stop, close or a lost connection.
    void takeControl();
    void giveControlBack();
    /// Held until it says so, or says nothing for `SessionLimits::hand`, or the robot falls silent; all end in a zero
    /// DRIVE at once. Without control it is not heard. `figures().control` tells what became of it.
    void drive(const usar::mission::HandIntent& intent);
    /// The hold ends, control stays; `reason` is a part of a sentence.
    void stopDriving(const QString& reason);
    void sendCommand(const usar::protocol::Command& command, const std::string& source);
    /// Hands out a copy of all that was scanned, for the export pool.
    void requestRecord();
    /// Of the height map, 0.02 .. 10 m. Before anything is scanned: a map keeps its cells.
    void setCellSize(double cell_size_m);
    /// The server's time is stopped on purpose, or runs again: until then silence is nothing to warn of.
    void expectSilence(bool expected);
    /// Something was made to go wrong, or is well again: kept with the record, the recording and the messages.
    void noteFault(const std::string& sentence);
    /// An empty map, without path and marks.
    void clearRecord();

    void stopRecording();
    /// `recordingFlushed` follows once all that happened until now is in the file. The recording goes on.
    void flushRecording();

    /// Instead of `open`: the lines come from a recording, paused at its beginning, and take the same way through the
    /// session. Nothing can be sent. `replayOpened` or `replayFailed` follows.
    void openRecording(const QString& path);
    void orderReplay(const usar::mission::ReplayOrder& order);

signals:
    /// `complaint` is a sentence about what the file has lost, or empty.
    void replayOpened(const usar::mission::RecordingFacts& facts, const QString& complaint);
    void replayFailed(const QString& reason);
    /// The file, or empty where nothing is recorded.
    void recordingFlushed(const QString& path);
    /// The last record has been played.
    void replayEnded();
    void linkChanged(const usar::link::LinkStatus& status);
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    void spawned(const QString& robot_name);
    /// Also said as a notice: silence after INIT, or the server hung up on it. Data may still come after silence (a
    /// paused simulator); then `spawned` follows.
    void spawnFailed(const QString& reason);
    /// `broke`: by a fault of its own; it may be started again.
    void behaviorFinished(bool success, const QString& reason, bool broke);
    /// At most one every 16 ms; costs nothing while nobody is connected to it.
    void updated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void recordReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void noticed(const usar::mission::Notice& notice);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

} // namespace usar::mission
