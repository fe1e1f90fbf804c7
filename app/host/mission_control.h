// The program without its window: simulator, link, robots, behaviors, results.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/robot.h"
#include "core/mission/fleet/scan_keeper.h"
#include "core/protocol/usual_values.h"
#include "core/server/embedded/simulator_host.h"

namespace usar::app {

using mission::Robot;
using mission::RobotView;
using mission::StartedBehavior;

/// Where robots live: in the simulator that comes with the program, or on a server.
struct ServerTarget {
    bool embedded = true;
    QString host = "127.0.0.1";
    quint16 port = protocol::usual_port::bot;
    server::SimulatorSpec simulator;
};

/// Notification key for the end of this robot's behavior.
inline QString missionKey(int id) {
    return QString("mission-%1").arg(id);
}

/// Owns the robots' sessions, the simulator thread and the keeper of scans; lives in the GUI thread and never waits in
/// it. One connection speaks for one robot, so a further one is kept open for the robot that is spawned next: it learns
/// the start poses, and its state is the state of the link.
class MissionControl : public QObject {
    Q_OBJECT
public:
    explicit MissionControl(QObject* parent = nullptr);
    ~MissionControl() override;

    /// Before `loadPlugins` or `rescanPlugins`: those plugins, by name, have a process of their own. `marks_folder` is
    /// where it is remembered which one ended the program.
    void isolatePlugins(const QStringList& names, const QString& marks_folder);
    void loadPlugins(const QStringList& folders) { plugins_.scan(folders); }
    /// More may follow in `pluginsChanged`: those with a process of their own are asked, and nobody waits for them.
    std::vector<agent::PluginChange> rescanPlugins() { return plugins_.rescan(); }
    /// Makes the next rescan query this plugin, even if its file is unchanged.
    void askPluginAgain(const QString& file) { plugins_.forget(file); }
    const agent::PluginLoader& plugins() const { return plugins_; }
    server::SimulatorHost& simulator() { return simulator_; }
    const ServerTarget& server() const { return target_; }
    const QString& level() const { return level_; }
    /// Where robots can be spawned; empty until the server has told.
    const std::vector<protocol::StartPose>& startPoses() const { return start_poses_; }
    /// The embedded simulator's world; empty on a real server.
    const server::WorldPicture& world() const { return world_; }
    /// What plugins can drive, and then what the embedded simulator has besides, which only commands drive.
    std::vector<agent::RobotDescription> robotsToSpawn() const;

    void connectTo(const ServerTarget& target);
    void disconnectFromServer();

    /// "R1": the name that the next robot gets when the person gives none.
    QString nextRobotName() const;
    /// Of the embedded simulator; a real server's time cannot be steered.
    void setPace(server::Pace pace, double factor);
    /// Next free key 1-9; an error where all are taken or there is no link.
    Result<int> spawn(mission::SpawnRequest request);
    Robot* robot(int id) const;
    std::vector<Robot*> robots() const;
    /// RobotView::connection of a robot, or with 0 of the session that waits for one; 0 where there is none.
    int connectionOf(int id) const;
    /// Whether a line can be sent there now; else why not.
    Result<void> checkLine(int connection) const;
    /// As it is, with `source` as its cause.
    Result<void> sendLine(int connection, const QString& line, const std::string& source);
    /// The robot stops and its connection closes; what it scanned is saved.
    void remove(int id);
    /// For a robot that never came, or went with a lost link: INIT anew, as it was asked for the first time.
    void spawnAgain(int id);
    /// `plan_path`: of a person's own POSH plan; empty: the robot's. `isolate`: in a process of its own.
    Result<void> startBehavior(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                               const std::map<std::string, agent::ParameterValue>& values, const QString& plan_path,
                               bool isolate = false);
    /// What the robot did when its behavior broke: the same with the same parameters, area and plan, in a process of
    /// its own.
    Result<void> startAgain(int id);
    /// Whether this mission can be flown here: plugin, parameters, area within the world, world. The parameters as the
    /// behavior takes them.
    Result<std::map<std::string, agent::ParameterValue>> prepareMission(const mission::Mission& mission) const;
    void stopAll();
    /// What the behavior would do with this task, before it starts. `id` may be 0: then from the map's origin. Told at
    /// once or later, as PluginLoader does.
    void preview(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                 const std::map<std::string, agent::ParameterValue>& values,
                 const agent::PluginLoader::Told& told) const;
    void forgetPreview() const { plugins_.forgetPreview(); }

    /// In the embedded simulator, from now on. An error names the first text that is no fault.
    Result<void> addFaults(const QStringList& texts);

    void setResultFolder(const QString& folder) { keeper_.setFolder(folder); }
    QString resultFolder() const { return keeper_.folder(); }
    bool resultFolderChosen() const { return keeper_.folderChosen(); }
    bool anythingToSave() const;
    void exportResults(int id);
    /// Every robot that is live, and each that comes, into a file of its own in the result folder. On at first.
    void setRecording(bool on);
    bool recording() const { return recording_; }
    /// Shown as a robot of its own, paused at its beginning; `replayAdded` says its id. Live robots go on.
    void openRecording(const QString& path);
    /// Opens the live robot's recording at `moment` (protocol clock); the robot is not interrupted. An earlier look
    /// back on it is closed.
    void lookBack(int id, Seconds moment);
    /// Whom that replay looks back on, as long as it is there; else 0.
    int lookedBackOn(int id) const;
    /// Stops every robot and saves what is not saved; `readyToClose` follows. A session that hangs is waited for five
    /// seconds. After `exportFailed` nothing more happens until this is called again, or `stayOpen`.
    void prepareToClose();
    bool closing() const { return closing_; }
    /// The person changed their mind.
    void stayOpen();
    void cure(const QString& key) { emit cured(key); }

signals:
    /// Of what has answered.
    void pluginsChanged(const std::vector<usar::agent::PluginChange>& changes);
    void linkChanged(const usar::link::LinkStatus& status);
    void worldKnown(const usar::server::WorldPicture& world);
    /// Other robots can be spawned now.
    void classesChanged();
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    void robotAdded(int id);
    /// Before `robotAdded`.
    void replayAdded(int id);
    /// `instead`: id to select if the removed robot was selected; 0 if none remain.
    void robotRemoved(int id, const QString& name, int instead);
    void robotLinkChanged(int id);
    /// Of the connection that waits for its robot.
    void linkUpdated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void robotUpdated(int id, std::shared_ptr<const usar::mission::SessionUpdate> update);
    void behaviorFinished(int id, bool success, const QString& reason);
    /// It threw, hung or died, which `text` says; `startAgain` may help. In place of `noticed`, with such a key.
    void behaviorBroke(int id, const QString& key, const QString& text);
    void resultsWritten(int id, const QStringList& files);
    /// The scan is still in memory.
    void exportFailed(int id, const QString& reason);
    /// `key` groups repeats and lets a cure clear them.
    void noticed(const QString& key, const usar::mission::Notice& notice);
    void cured(const QString& key);
    void readyToClose();

private:
    static constexpr int most_robots = 9; ///< one key each

    int nextId() const;
    Robot* robotOn(int connection) const;
    void open(const QString& path, int looks_back_on, std::optional<Seconds> moment);
    void wireSimulator();
    void learn(const QString& class_name, bool has_camera);
    void openNext();
    void connectRobot(Robot* robot);
    void connectReplay(Robot* robot);
    void addReplay(Robot* robot, const mission::RecordingFacts& facts, const QString& complaint);
    void record(Robot& robot, const mission::SpawnRequest& as);
    QString unusedName(const QString& name) const;
    void tell(Robot* robot, const mission::Notice& notice);
    void linkMoved(Robot* robot);
    /// The next robot of a snapshot gets the connection that is free.
    void goOnWithNext();
    void finished(Robot* robot, bool success, const QString& reason);
    Result<void> startOn(Robot& robot, const StartedBehavior& start);
    void exported(int id, const QStringList& files);
    void closeWhenSaved();
    Result<void> checkArea(const Rectangle& area_in_map) const;
    void note(Severity severity, const QString& key, const QString& text);

    agent::PluginLoader plugins_;
    server::SimulatorHost simulator_;
    mission::ScanKeeper keeper_;
    QTimer patience_; ///< runs while the window waits to close
    ServerTarget target_;
    QString host_;
    quint16 port_ = 0;
    QString level_;
    std::vector<protocol::StartPose> start_poses_;
    server::WorldPicture world_; ///< empty on a real server
    std::map<int, std::unique_ptr<Robot>> robots_;
    std::unique_ptr<Robot> next_;                 ///< connected, not spawned
    std::vector<std::unique_ptr<Robot>> opening_; ///< replays that are not open yet
    std::map<int, Seconds> wanted_moments_;       ///< by connection: to look back on, once it is in the file
    bool recording_ = true;
    bool time_stopped_ = false;                    ///< of the embedded simulator
    std::map<int, mission::TrueFigures> truths_;   ///< of robots by id; for the summary only
    std::vector<sim::Simulation::Orphan> waiting_; ///< robots of a snapshot that want a connection each
    bool closing_ = false;
};

} // namespace usar::app
