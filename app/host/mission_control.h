// The program without its window: simulator, connections, robots, behaviors and results.
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

/// The server to connect to: the simulator that comes with the program, or a USARSim server.
struct ServerTarget {
    bool embedded = true;
    QString host = "127.0.0.1";               ///< of a USARSim server, as is `port`
    quint16 port = protocol::usual_port::bot; ///< its bot port
    server::SimulatorSpec simulator; ///< of the embedded simulator; the wireless port also applies to a USARSim server
};

/// Notification key for the end of this robot's behavior.
inline QString missionKey(int id) {
    return QString("mission-%1").arg(id);
}

/// Owns the robots' sessions, the simulator's host and the keeper of scans. Belongs to the GUI thread and never blocks
/// it. In the protocol each connection has one robot, so one more connection is kept open for the next robot: it gets
/// the start poses, and its state counts as the state of the link to the server. Ids of robots are 1-9, the keys that
/// select them; calls with an unknown id have no effect unless they return an error.
class MissionControl : public QObject {
    Q_OBJECT
public:
    explicit MissionControl(QObject* parent = nullptr);
    ~MissionControl() override;

    /// Sets the plugins, by name, that have a process of their own; takes effect with the next `loadPlugins` or
    /// `rescanPlugins`. `marks_folder` stores which plugins have ended the program while they were being loaded.
    void isolatePlugins(const QStringList& names, const QString& marks_folder);
    void loadPlugins(const QStringList& folders) { plugins_.scan(folders); }
    /// Returns the changes. Those of plugins with a process of their own follow in `pluginsChanged` once it has
    /// answered.
    std::vector<agent::PluginChange> rescanPlugins() { return plugins_.rescan(); }
    /// Makes the next rescan query this plugin, even if its file is unchanged.
    void askPluginAgain(const QString& file) { plugins_.forget(file); }
    const agent::PluginLoader& plugins() const { return plugins_; }
    server::SimulatorHost& simulator() { return simulator_; }
    const ServerTarget& server() const { return target_; }
    /// Name of the world that the server has reported; empty until then.
    const QString& level() const { return level_; }
    /// The poses on which robots can be spawned; empty until the server has reported them.
    const std::vector<protocol::StartPose>& startPoses() const { return start_poses_; }
    /// The embedded simulator's world; empty on a real server.
    const server::WorldPicture& world() const { return world_; }
    /// The robots that plugins have behaviors for, followed by the embedded simulator's other robots, which can only be
    /// driven by commands and by hand.
    std::vector<agent::RobotDescription> robotsToSpawn() const;

    /// Leaves the current server first, as `disconnectFromServer` does.
    void connectTo(const ServerTarget& target);
    /// Removes all robots except replays, and stops the embedded simulator.
    void disconnectFromServer();

    /// "R1": the name that the next robot gets if the user gives none.
    QString nextRobotName() const;
    /// Sets the embedded simulator's pace; `factor` is in simulated seconds per real second. The time of a real server
    /// cannot be controlled.
    void setPace(server::Pace pace, double factor);
    /// Spawns a robot and returns its id, the lowest free one; an empty name means the next free "R1". Fails if all ids
    /// or the name are taken, no class is given, or there is no link. Whether the server has confirmed the robot is in
    /// `RobotView::figures`.
    Result<int> spawn(mission::SpawnRequest request);
    /// Returns nullptr if there is no such robot. The pointer is valid until the robot is removed.
    Robot* robot(int id) const;
    /// All robots, replays included, in the order of their ids.
    std::vector<Robot*> robots() const;
    /// RobotView::connection of a robot or, for id 0, of the connection that waits for one; 0 if there is none.
    int connectionOf(int id) const;
    /// Fails with the reason if no line can be sent on this connection now.
    Result<void> checkLine(int connection) const;
    /// Sends the line unchanged, with `source` as its cause. Fails as `checkLine` does.
    Result<void> sendLine(int connection, const QString& line, const std::string& source);
    /// Stops the robot and closes its connection; what it has scanned is saved.
    void remove(int id);
    /// Sends INIT again with the same class, name and pose, for a robot that has not come or was lost with its link.
    void spawnAgain(int id);
    /// `plan_path`: the user's own POSH plan; empty: the robot's. `isolate`: run it in a process of its own. Fails if
    /// the plugin, plan, area or parameters do not allow it.
    Result<void> startBehavior(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                               const std::map<std::string, agent::ParameterValue>& values, const QString& plan_path,
                               bool isolate = false);
    /// Starts the robot's last behavior again, with the same parameters, area and plan, in a process of its own; for a
    /// behavior that has failed by itself.
    Result<void> startAgain(int id);
    /// Checks that this mission can be flown here: world, behavior, parameters, plan, area inside the world. Returns
    /// the parameters in the behavior's units.
    Result<std::map<std::string, agent::ParameterValue>> prepareMission(const mission::Mission& mission) const;
    /// Stops every robot with its safe command.
    void stopAll();
    /// Computes what the behavior would do with this task. It starts from the robot's start pose, or from the map's
    /// origin if there is no such robot. `told` is called at once or later; see PluginLoader::preview.
    void preview(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                 const std::map<std::string, agent::ParameterValue>& values,
                 const agent::PluginLoader::Told& told) const;
    void forgetPreview() const { plugins_.forgetPreview(); }

    /// Adds faults to the embedded simulator; their times are relative to now. The error names the first text that is
    /// not a fault.
    Result<void> addFaults(const QStringList& texts);

    /// Sets the folder for results and recordings; empty: the default one.
    void setResultFolder(const QString& folder) { keeper_.setFolder(folder); }
    QString resultFolder() const { return keeper_.folder(); }
    bool resultFolderChosen() const { return keeper_.folderChosen(); }
    /// True while a behavior runs or part of a scan is not on disk.
    bool anythingToSave() const;
    /// Saves what the robot has scanned so far; `resultsWritten` or `exportFailed` follows.
    void exportResults(int id);
    /// Switches the recording of all current and later robots on or off, each into its own file in the result folder.
    /// Initially on.
    void setRecording(bool on);
    bool recording() const { return recording_; }
    /// Opens a recording as a robot of its own, paused at its beginning; `replayAdded` gives its id. Live robots
    /// continue. A failure is a notice.
    void openRecording(const QString& path);
    /// Opens the live robot's recording at `moment` (protocol clock) as a replay, without interrupting the robot. An
    /// earlier such replay of this robot is closed.
    void lookBack(int id, Seconds moment);
    /// Id of the live robot whose past the replay `id` shows; 0 if `id` is no such replay or that robot is gone.
    int lookedBackOn(int id) const;
    /// Stops every robot and saves what is unsaved; `readyToClose` follows, after five seconds at the latest if a
    /// session hangs. After `exportFailed` nothing more happens until this or `stayOpen` is called.
    void prepareToClose();
    bool closing() const { return closing_; }
    /// Cancels closing, because the user has changed their mind.
    void stayOpen();
    void cure(const QString& key) { emit cured(key); }

signals:
    /// Plugins with a process of their own have answered.
    void pluginsChanged(const std::vector<usar::agent::PluginChange>& changes);
    /// State of the connection that waits for the next robot.
    void linkChanged(const usar::link::LinkStatus& status);
    /// The embedded simulator is ready; not emitted for a real server.
    void worldKnown(const usar::server::WorldPicture& world);
    /// The result of `robotsToSpawn` has changed.
    void classesChanged();
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    /// The robot exists in the window; the server may not have confirmed it yet.
    void robotAdded(int id);
    /// Emitted before `robotAdded` if the robot is a replay.
    void replayAdded(int id);
    /// `instead`: id to select if the removed robot was selected; 0 if none remain.
    void robotRemoved(int id, const QString& name, int instead);
    void robotLinkChanged(int id);
    /// Update of the connection that waits for the next robot.
    void linkUpdated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void robotUpdated(int id, std::shared_ptr<const usar::mission::SessionUpdate> update);
    void behaviorFinished(int id, bool success, const QString& reason);
    /// A behavior threw, hung or died, as `text` says; `startAgain` may help. Emitted in place of `noticed`.
    void behaviorBroke(int id, const QString& key, const QString& text);
    void resultsWritten(int id, const QStringList& files);
    /// The scan is still in memory.
    void exportFailed(int id, const QString& reason);
    /// `key` identifies the problem, for repetitions and for `cured`.
    void noticed(const QString& key, const usar::mission::Notice& notice);
    /// The problem with this key is over.
    void cured(const QString& key);
    void readyToClose();

private:
    static constexpr int most_robots = 9; ///< one number key each

    int nextId() const;
    Robot* robotOn(int connection) const;
    void open(const QString& path, int looks_back_on, std::optional<Seconds> moment);
    void wireSimulator();
    /// Adds a class of the embedded simulator, or replaces it.
    void learn(const QString& class_name, bool has_camera);
    /// Opens the connection for the next robot.
    void openNext();
    void connectRobot(Robot* robot);
    void connectReplay(Robot* robot);
    void addReplay(Robot* robot, const mission::RecordingFacts& facts, const QString& complaint);
    void record(Robot& robot, const mission::SpawnRequest& as);
    QString unusedName(const QString& name) const;
    void tell(Robot* robot, const mission::Notice& notice);
    void linkMoved(Robot* robot);
    /// Gives the free connection to the next robot of a resumed snapshot.
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
    QTimer patience_; ///< limits how long closing waits for sessions
    ServerTarget target_;
    QString host_;
    quint16 port_ = 0;
    QString level_;
    std::vector<protocol::StartPose> start_poses_;
    server::WorldPicture world_; ///< empty on a real server
    std::map<int, std::unique_ptr<Robot>> robots_;
    std::unique_ptr<Robot> next_;                 ///< the connection for the next robot; null: no server
    std::vector<std::unique_ptr<Robot>> opening_; ///< replays that are not open yet
    std::map<int, Seconds> wanted_moments_;       ///< moments to look back on once they are in the file, by connection
    bool recording_ = true;
    bool time_stopped_ = false;                    ///< the embedded simulator is paused
    std::map<int, mission::TrueFigures> truths_;   ///< for the summary only; by id
    std::vector<sim::Simulation::Orphan> waiting_; ///< robots of a resumed snapshot that have no connection yet
    bool closing_ = false;
};

} // namespace usar::app
