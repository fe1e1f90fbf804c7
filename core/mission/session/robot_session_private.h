// Implementation of RobotSession: its parts and the steps of its life. Included by its own .cpp files only.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QSocketNotifier>
#include <QTimer>

#include "core/link/recording_writer.h"
#include "core/link/replay.h"
#include "core/mission/hand/hand_driver.h"
#include "core/mission/session/behavior_so_far.h"
#include "core/mission/session/complaint_book.h"
#include "core/mission/session/drive_gate.h"
#include "core/mission/session/robot_session.h"
#include "core/mission/session/safe_stop.h"
#include "core/mission/session/scan_mapper.h"
#include "core/mission/session/sensor_watch.h"
#include "core/mission/session/update_collector.h"
#include "core/modules/state.h"
#include "core/protocol/dialect_detector.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// Returns "host:port".
inline std::string placeOf(const link::LinkStatus& status) {
    return status.host.toStdString() + ':' + std::to_string(status.port);
}

inline std::chrono::milliseconds toMilliseconds(Seconds span) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(span);
}

struct RobotSession::Private : link::ReplayTaker {
    Private(RobotSession& session, double cell_size_m);

    void opened();
    /// A connection begins, live or replayed.
    void beginConnection();
    void connectionLost();
    void takeLine(std::string_view text);
    void noteMessage(const protocol::InfoLine& line);
    void noteData();
    void takeOutput(agent::RunningBehavior::Output& output, bool is_tick);
    void takePublished(const std::vector<agent::Published>& published);
    void takeValue(const agent::Published& value);
    void endTick();
    /// Takes the end of a behavior that ended between two calls.
    void behaviorEnded();
    /// Fails for names that no line can contain.
    static Result<protocol::Init> initOf(const SpawnRequest& request);
    void init(const SpawnRequest& request);
    void setSpawn(SpawnState now);
    void failSpawn(SpawnState now, const std::string& reason);
    void watch();
    void watchSilence();
    void watchSensors();
    void watchQueue();
    void stopBehavior(const std::string& source, const std::string& reason);
    void finishBehavior(const agent::BehaviorFinished& finished, bool is_published);
    void worthSaving();
    void step();
    /// Sends the STEP that a halted plan has held back, once the plan runs again or has ended.
    void stepOwed();
    void makeSafe(const std::string& source);
    std::vector<protocol::Command> stops(const std::optional<protocol::Command>& safe) const;
    void send(const agent::CausedCommand& command);
    void sendDrive(bool at_once);
    /// True while the server reads more slowly than we write.
    bool congested() const { return link.unsentBytes() > limits.unsent_bytes; }
    void write(const agent::CausedCommand& command);
    void countTraffic();

    void setUpHand();
    void beginHand();
    void askForHand();
    void endHand(const std::string& reason);
    void takeHand(const HandIntent& intent);
    void beatHand();
    void tickHand();
    void stopHand(const std::string& reason);
    void sendHand(const HandDriver::Commands& commands, const std::string& source, bool at_once);
    void showControl();
    Seconds wallTime() const { return Seconds(static_cast<double>(wall.nsecsElapsed()) * 1e-9); }

    /// Reports something that needs no later `over`.
    void say(Severity severity, std::string topic, std::string text);
    /// Reports a problem that lasts until `over` is called with the same topic.
    void trouble(Severity severity, const std::string& topic, std::string text);
    /// Reports the end of a problem; does nothing if there was no such problem.
    void over(const std::string& topic, std::string text = {});
    void endTroubles(bool all);
    const link::LinkStatus& linkStatus() const { return replayer ? replay_link : link.status(); }
    bool connected() const { return linkStatus().state == link::LinkState::Connected; }

    Result<void> beginRecording(const QString& path, RecordingFacts facts);
    /// The behavior named in `record` has begun.
    void noteTask();
    void noteForRecording(const char* topic, std::string_view text);
    void notePublished(const agent::Published& value);
    void watchRecording();
    void endRecording();
    void beginReplay(std::unique_ptr<link::RecordingReader> recording);
    void endReplay();
    /// True in a replay, in which nothing can be sent; reports that once.
    bool refusedInReplay();
    void setReplayLink(link::LinkState state, std::string_view reason);
    void takeReplayed(const agent::Published& value);
    void rewound() override;
    void opened(std::string_view place) override;
    void closed(std::string_view reason) override;
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override;
    void note(const link::Record& record) override;
    void quiet(bool on) override;
    void lookForObservers();
    void touched();
    void emitFrame();

    RobotSession& q;
    link::TcpLink link;
    QTimer frame_timer;
    QTimer watch_timer;
    QTimer recording_timer; ///< checks the recorder
    QTimer hand_timer;      ///< runs while an input device holds the robot
    QElapsedTimer wall;     ///< since the session was created
    QElapsedTimer since_opened;
    QElapsedTimer since_init;
    QElapsedTimer since_data;
    SessionLimits limits;

    protocol::Reader reader;
    std::optional<modules::StateModule> state{std::in_place}; ///< a new one for each connection
    ComplaintBook complaints;
    SensorWatch sensors;
    DriveGate gate;
    MovingParts moving;
    HandDriver hand;
    protocol::DialectDetector dialect;
    ScanMapper mapper;
    UpdateCollector collector;
    ScanRecord record;
    SessionFigures figures;              ///< `traffic` as of the last countTraffic()
    std::uint64_t complaints_before = 0; ///< from earlier connections
    std::shared_ptr<agent::RunningBehavior> host;
    BehaviorSoFar so_far;                       ///< what `host` has published
    std::unique_ptr<QSocketNotifier> end_watch; ///< for a behavior that may end between two calls

    std::unique_ptr<link::RecordingWriter> recorder;
    std::unique_ptr<link::Replayer> replayer;
    link::LinkStatus replay_link;
    protocol::TrafficCounts replay_traffic;
    /// While a replay seeks: the newest value of each kind of which only the newest matters.
    std::map<std::size_t, agent::Published> newest_on_the_way;
    bool on_the_way = false;

    std::set<std::string> troubles; ///< topics that were reported and are not over
    SpawnRequest request;
    std::optional<SpawnRequest> after_reconnect;
    Seconds last_tick{0.0};    ///< time of the last STA, by `wall`
    Seconds tick_spacing{0.0}; ///< time between the last two STA, likewise
    bool lockstep_wanted = false;
    bool start_poses_settled = false; ///< they came, or their absence was reported
    bool silence_said = false;
    bool step_held = false; ///< a plan is halted, and the server's time with it
    bool silence_expected = false;
    bool unplaced_said = false;
    bool observed = false; ///< `updated` has receivers; checked at connect and once per frame
};

} // namespace usar::mission
