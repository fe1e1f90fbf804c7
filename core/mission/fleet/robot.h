// One robot as the window knows it: its session in a thread of its own, and the newest of what the session said.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QThread>

#include "core/agent/behavior_start.h"
#include "core/mission/session/robot_session.h"

namespace usar::mission {

/// Newest values, for a view that is shown late or switched to this robot.
struct RobotView {
    int connection = 0; ///< another number for every session of this run of the program
    int id = 0;         ///< 1-9, the key that selects it; 0 while no robot is spawned
    mission::SpawnRequest spawn;
    link::LinkStatus link;
    mission::SessionFigures figures;
    std::string behavior_id;
    Rectangle area_in_map;
    std::optional<agent::BehaviorStatus> status;
    std::optional<agent::BehaviorFinished> finished;
    std::optional<Pose> base_in_map;
    std::vector<Vec2> trail_m;
    std::vector<agent::MapMark> marks;
    std::vector<Vec2> planned_m;
    std::optional<Vec3> goal_m;
    std::map<mapping::GridIndex, std::shared_ptr<const mapping::HeightTile>> tiles;
    std::optional<mapping::HeightRange> height_range;
    std::optional<mapping::CourseProfile> ground;
    double cell_size_m = 0.25;                       ///< of the height map
    std::map<mapping::GridIndex, int> covered_cells; ///< by tile: known cells within the mission area
    bool paused = false;                             ///< by the person, or until the behavior ends it
    bool unsaved = false;                            ///< scanned since the last export
    bool broke = false;                      ///< the behavior ended by a fault of its own; none was started since
    std::optional<agent::PlanHalted> halted; ///< the plan stands still
    QString recording;                       ///< the file that is replayed; empty: live
    int looks_back_on = 0; ///< `connection` of the robot that flew when this replay of it was opened; 0: of none
};

/// A behavior as it was started, with what became of its parameters and its plan meanwhile.
struct StartedBehavior {
    std::string id;
    Rectangle area_in_map;
    std::map<std::string, agent::ParameterValue> parameters;
    std::optional<agent::PlanText> plan; ///< in place of the robot's own
    bool isolated = false;
};

/// Lives in the GUI thread; the session lives in its own. Calls are queued to it and never wait.
class Robot : public QObject {
    Q_OBJECT
public:
    explicit Robot(QObject* parent = nullptr);
    /// Says the safe command and closes. Waits two seconds at most: a behavior that hangs hurts only its robot.
    ~Robot() override;

    const RobotView& view() const { return view_; }
    bool spawned() const { return view_.id != 0; }
    /// Part of the mission area whose height is known; nothing without an area.
    std::optional<double> coverage_pct() const;
    /// From the start of the newest behavior to its end, or until now; 0 before the first.
    Seconds wallTime() const;
    /// A behavior of ours: one in a replay has run.
    bool running() const { return view_.figures.behavior_running && !view_.finished && !isReplay(); }
    bool isReplay() const { return !view_.recording.isEmpty(); }

    void open(const QString& host, quint16 port, bool lockstep);
    void close();
    void spawn(int id, const mission::SpawnRequest& request);
    /// Plugins are code of other people: what they throw or refuse comes back as an error.
    Result<void> startBehavior(const agent::PluginLoader& plugins, const std::string& behavior_id,
                               const Rectangle& area_in_map, const agent::ParameterSet& parameters,
                               const std::optional<agent::PlanText>& plan,
                               const std::optional<agent::Isolation>& isolation);
    /// The newest; nothing before the first.
    const std::optional<StartedBehavior>& started() const { return started_; }
    /// True where the cells change by it. A map that has heights keeps its cells; a notice says so.
    bool setCellSize(double cell_size_m);
    void order(agent::Order order);
    void setParameters(const agent::ParameterSet& parameters);
    /// For the plan that decides. Breakpoints are kept for behaviors that start later.
    void control(const agent::PlanControl& control);
    void stop();
    /// The server's time is stopped on purpose, or runs again.
    void expectSilence(bool expected);
    /// The person drives; a behavior that runs is paused. See RobotSession.
    void takeControl();
    void giveControlBack();
    void drive(const mission::HandIntent& intent);
    void stopDriving(const QString& reason);
    void send(const protocol::Command& command, const std::string& source);
    void requestRecord();
    void startRecording(const QString& path, const mission::RecordingFacts& facts);
    void stopRecording();
    /// `recordingFlushed` follows once all that happened until now is in the file.
    void flushRecording();
    void noteFault(const QString& sentence);
    /// Instead of `open`; `replayOpened` or `replayFailed` follows.
    void openRecording(const QString& path, int looks_back_on = 0);
    void orderReplay(const mission::ReplayOrder& order);
    /// From now on it is the robot of that recording.
    void becomeReplay(int id, const QString& robot_name, const mission::RecordingFacts& facts);
    void markSaved() { view_.unsaved = false; }
    void markUnsaved() { view_.unsaved = true; }

signals:
    void linkChanged();
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    void updated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void behaviorFinished(bool success, const QString& reason);
    void recordReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void noticed(const usar::mission::Notice& notice);
    /// Empty where nothing is recorded.
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
    mission::RobotSession* session_; ///< lives in thread_ and is deleted there
    RobotView view_;
    bool pause_confirmed_ = false; ///< the behavior has said that it pauses
    agent::SetBreakpoints breakpoints_;
    std::optional<StartedBehavior> started_;
    QElapsedTimer since_start_;
    std::optional<Seconds> took_;               ///< wall time of the behavior that has ended
    std::optional<agent::PlanText> asked_plan_; ///< to take the place of the one that runs
};

} // namespace usar::mission
