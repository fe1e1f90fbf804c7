// One robot as the window knows it: its session in a thread of its own, and the session's newest values.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QThread>

#include "core/agent/behavior_start.h"
#include "core/mapping/height_probe.h"
#include "core/mission/session/robot_session.h"

namespace usar::mission {

/// Newest values of a robot, for views that show it later or switch to it. Positions are in meters in the map frame; an
/// absent value has not been reported yet.
struct RobotView {
    int connection = 0; ///< number of the session, unique while the program runs
    int id = 0;         ///< 1-9, the key that selects it; 0 while no robot is spawned
    mission::SpawnRequest spawn;
    link::LinkStatus link;
    mission::SessionFigures figures;
    std::string behavior_id; ///< id of the newest behavior; empty: none was started
    Rectangle area_in_map;   ///< its area; empty: none
    std::optional<agent::BehaviorStatus> status;
    std::optional<agent::BehaviorFinished> finished; ///< absent until it has ended
    std::optional<Pose> base_in_map; ///< as the behavior estimates it; from the INS until the first status
    std::vector<Vec2> trail_m;       ///< estimated positions, more than 0.2 m apart
    std::vector<agent::MapMark> marks;
    std::vector<Vec2> planned_m; ///< path that the behavior has planned
    std::optional<Vec3> goal_m;
    mapping::HeightTiles tiles;
    std::optional<mapping::HeightRange> height_range; ///< range of the whole height map; absent: the map is empty
    std::optional<mapping::CourseProfile> ground;
    double cell_size_m = 0.25;                       ///< edge of a height map cell
    std::map<mapping::GridIndex, int> covered_cells; ///< number of known cells in the mission area, by tile
    bool paused = false;                             ///< by the user; cleared when the behavior resumes or ends
    bool unsaved = false;                            ///< something was scanned since the last export
    bool broke = false;                              ///< the behavior failed by itself, and none was started since
    std::optional<agent::PlanHalted> halted;         ///< the plan's halt; absent: it is not halted
    QString recording;                               ///< the file that is replayed; empty: live
    int looks_back_on = 0; ///< `connection` of the live robot whose past this replay shows; 0: none
};

/// A behavior as it was started, with later changes of its parameters and plan applied.
struct StartedBehavior {
    std::string id;
    Rectangle area_in_map;
    std::map<std::string, agent::ParameterValue> parameters;
    std::optional<agent::PlanText> plan; ///< the user's plan; absent: the robot's own
    bool isolated = false;               ///< it runs in a separate process
};

/// Belongs to the GUI thread, while its RobotSession runs in a thread of its own: calls are queued to that thread and
/// never wait, so their effect shows in a later update. Calls that are not described here do what the session's
/// function of the same name does.
class Robot : public QObject {
    Q_OBJECT
public:
    explicit Robot(QObject* parent = nullptr);
    /// Sends the safe command and closes the connection. Waits at most two seconds for the session's thread, which is
    /// left behind if a plugin hangs in it.
    ~Robot() override;

    const RobotView& view() const { return view_; }
    /// True once `spawn` or `becomeReplay` was called; the server may not have confirmed the robot yet.
    bool spawned() const { return view_.id != 0; }
    /// Percentage of the mission area whose height is known, 0..100; nullopt without an area.
    std::optional<double> coverage_pct() const;
    /// Wall time from the start of the newest behavior to its end, or until now; 0 before the first.
    Seconds wallTime() const;
    /// True while a behavior of ours runs; the one in a replay does not count.
    bool running() const { return view_.figures.behavior_running && !view_.finished && !isReplay(); }
    bool isReplay() const { return !view_.recording.isEmpty(); }

    /// `lockstep`: ask the server to wait for our STEP after each tick.
    void open(const QString& host, quint16 port, bool lockstep);
    void close();
    void spawn(int id, const mission::SpawnRequest& request);
    /// Plugins are third-party code: if one throws or refuses, this returns an error. `plan` nullopt: the robot's own
    /// plan. `isolation` nullopt: the behavior runs in this program.
    Result<void> startBehavior(const agent::PluginLoader& plugins, const std::string& behavior_id,
                               const Rectangle& area_in_map, const agent::ParameterSet& parameters,
                               const std::optional<agent::PlanText>& plan,
                               const std::optional<agent::Isolation>& isolation);
    /// The newest started behavior; nullopt before the first.
    const std::optional<StartedBehavior>& started() const { return started_; }
    /// Returns true if this changes the cells. A map that has heights keeps its cell size, and a notice says so.
    bool setCellSize(double cell_size_m);
    void order(agent::Order order);
    void setParameters(const agent::ParameterSet& parameters);
    /// Controls the plan of the behavior. Breakpoints are also kept for behaviors that start later.
    void control(const agent::PlanControl& control);
    void stop();
    /// `expected`: the server's time is stopped on purpose, so silence is not reported.
    void expectSilence(bool expected);
    /// The user drives from now on; a running behavior is paused. See RobotSession.
    void takeControl();
    void giveControlBack();
    void drive(const mission::HandIntent& intent);
    void stopDriving(const QString& reason);
    void send(const protocol::Command& command, const std::string& source);
    void requestRecord();
    void startRecording(const QString& path, const mission::RecordingFacts& facts);
    void stopRecording();
    /// `recordingFlushed` follows once everything up to now is in the file.
    void flushRecording();
    void noteFault(const QString& sentence);
    /// Replaces `open`; `replayOpened` or `replayFailed` follows. `looks_back_on`: see RobotView.
    void openRecording(const QString& path, int looks_back_on = 0);
    void orderReplay(const mission::ReplayOrder& order);
    /// Turns this object into the robot of the opened recording.
    void becomeReplay(int id, const QString& robot_name, const mission::RecordingFacts& facts);
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
    void noticed(const usar::mission::Notice& notice);
    /// `path` is the file, or empty if nothing is recorded.
    void recordingFlushed(const QString& path);
    void replayOpened(const usar::mission::RecordingFacts& facts, const QString& complaint);
    void replayFailed(const QString& reason);

private:
    void connectSession();
    void take(const mission::SessionUpdate& update);
    void take(const agent::Published& published);
    void forget();
    void countCovered();
    void countCovered(const mapping::HeightTile& tile);
    template <class Call>
    void later(Call call);

    QThread* thread_;                ///< outlives this object only if a plugin hangs in it
    mission::RobotSession* session_; ///< belongs to thread_ and is deleted there
    RobotView view_;
    bool pause_confirmed_ = false; ///< the behavior has reported that it is paused
    agent::SetBreakpoints breakpoints_;
    std::optional<StartedBehavior> started_;
    QElapsedTimer since_start_;
    std::optional<Seconds> took_;               ///< wall time of the behavior that has ended
    std::optional<agent::PlanText> asked_plan_; ///< replacement that the running plan has not been exchanged for yet
};

} // namespace usar::mission
