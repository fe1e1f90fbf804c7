// All robots of the user: their sessions, behaviors, recordings and results, on any server.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mapping/height_look.h"
#include "core/mission/files/map_formats.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/robot.h"
#include "core/mission/runs/run_summary.h"

namespace usar::mission {

/// Notification key for the end of this robot's behavior.
inline QString missionKey(RobotId id) {
    return QString("mission-%1").arg(id.value);
}

/// Owns the plugins, the robots' sessions and the ScanKeeper. Belongs to the GUI thread and never blocks it. Each
/// connection serves one robot, so a spare connection is kept open for the robot that is spawned next: it learns the
/// start poses, and its state is the state of the link.
class Fleet : public QObject {
    Q_OBJECT
public:
    /// `behavior_host`: path of the program that runs isolated behaviors and plugins in separate processes.
    explicit Fleet(const QString& behavior_host, QObject* parent = nullptr);
    ~Fleet() override;

    /// Selects the plugins, by name, that get a process of their own; call it before a scan. `marks_folder` keeps a
    /// record of which plugin ended the program.
    void isolatePlugins(const QStringList& names, const QString& marks_folder);
    /// After a scan, `pluginsChanged` reports the plugins that have answered.
    agent::PluginLoader& plugins();
    const agent::PluginLoader& plugins() const;

    /// Opens the spare connection. `lockstep`: ask the server to wait for this program; `advice`: see RobotSession.
    void openLink(const QString& host, quint16 port, bool lockstep, const QString& equipment_advice = {});
    /// Removes all robots except replays, and closes the spare connection.
    void disconnectFromServer();
    const QString& level() const;
    /// Poses at which robots can be spawned; empty until the server has sent them.
    const std::vector<protocol::StartPose>& startPoses() const;
    void setDryAbove(std::optional<double> z_m);         ///< see agent::Task; forgotten by `disconnectFromServer`
    void setWorldExtent(const Rectangle& extent_in_map); ///< meters; empty: unknown, as after `disconnectFromServer`
    /// Call with true when the server's time is stopped on purpose, with false when it runs again. Holds for later
    /// connections, too.
    void expectSilence(bool expected);
    void noteFault(const QString& sentence); ///< tells each robot on the server that a fault has begun or ended
    /// Sets the true figures for the summary of the robot with this name; they are kept until the robot is removed.
    void setTruth(const std::string& robot_name, const TrueFigures& truth);
    void setSeed(std::optional<std::uint64_t> seed); ///< for summaries; forgotten by `disconnectFromServer`
    void setTruthMaker(std::function<Truth()> make); ///< SimulatorFacts::make_truth; forgotten likewise

    QString nextRobotName() const;
    Result<RobotId> spawn(SpawnRequest request); ///< the lowest free id; an error: too many robots, or no link
    Robot* robot(RobotId id) const;              ///< nullptr if there is none
    std::vector<Robot*> robots() const;
    /// RobotView::connection of the robot, or of the spare connection if `id` is 0; 0 if there is none.
    ConnectionId connectionOf(RobotId id) const;
    Result<void> checkLine(ConnectionId connection) const; ///< an error says why no line can be sent there now
    Result<void> sendLine(ConnectionId connection, const QString& line, const by::Source& source); ///< unchanged
    void remove(RobotId id);     ///< stops the robot, closes its connection and saves its scan
    void spawnAgain(RobotId id); ///< sends INIT again, for a robot that never appeared or was lost with its link
    /// `plan_path`: the user's own POSH plan; empty: the robot's. `isolate`: run in a separate process.
    Result<void> startBehavior(RobotId id, const std::string& behavior_id, const Rectangle& area_in_map,
                               const std::map<std::string, agent::ParameterValue>& values, const QString& plan_path,
                               bool isolate = false);
    /// Spawns a robot that takes over the recording's map and flies the rest. An error if nothing is left or possible.
    Result<RobotId> flyRest(const std::shared_ptr<const RecordedScan>& earlier);
    /// Restarts the behavior that broke, with the same parameters, area and plan, in a separate process.
    Result<void> startAgain(RobotId id);
    Result<std::map<std::string, agent::ParameterValue>> prepareMission(const Mission& mission) const; ///< checkMission
    void stopAll();
    /// Asks what the behavior would do with this task, before it starts. If `id` is 0, the task starts at the map's
    /// origin. As with PluginLoader, `told` is called at once or later.
    void preview(RobotId id, const std::string& behavior_id, const Rectangle& area_in_map,
                 const std::map<std::string, agent::ParameterValue>& values,
                 const agent::PluginLoader::Told& told) const;

    void setResultFolder(const QString& folder);
    QString resultFolder() const;
    bool resultFolderChosen() const;
    void setPictureLook(const mapping::HeightLook& look); ///< exported pictures get the look of the map
    bool anythingToSave() const;
    void exportResults(RobotId id);
    void exportMap(RobotId id, const FormatList& formats, const QString& folder); ///< an error is a notice
    void cancelSaving(); ///< stops all saves that run; `exportFailed` follows for each
    /// Each live robot, present or future, is recorded to a file in the result folder. This is on at first.
    void setRecording(bool on);
    void setRecordingLimit(RecordingLimit limit_bytes); ///< of each recording, present or future; at first none
    bool recording() const;
    /// Opens a recording as a further robot, paused, which carries out `first`; `replayAdded` gives its id. It is named
    /// as recorded, or after `title`.
    void openRecording(const QString& path, const ReplayOrder& first = {}, const QString& title = {});
    /// Opens the live robot's recording at `moment` (protocol clock); the robot is not interrupted. An earlier replay
    /// that was opened for it in this way is closed.
    void lookBack(RobotId id, Seconds moment);
    /// Id of the live robot that this replay was opened for by `lookBack`; 0 if there is none, or none any longer.
    RobotId lookedBackOn(RobotId id) const;
    /// Stops every robot and saves every unsaved scan; `readyToClose` follows. Waits up to five seconds for a session
    /// that hangs. After `exportFailed` nothing more happens until this or `stayOpen` is called.
    void prepareToClose();
    bool closing() const;
    void stayOpen(); ///< cancels `prepareToClose`
    void cure(const QString& key) { emit cured(key); }

signals:
    void pluginsChanged(const std::vector<usar::agent::PluginChange>& changes); ///< after a scan; those that answered
    void linkChanged(const usar::link::LinkStatus& status);
    void nextConnected(); ///< the spare connection is open and `linkChanged` was emitted: a robot can be spawned
    /// Emitted by `disconnectFromServer`, before `linkChanged`: the server is no longer needed.
    void serverLeft();
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    void robotAdded(usar::RobotId id);
    void replayAdded(usar::RobotId id); ///< before `robotAdded`
    /// `instead`: id to select if the removed robot was selected; 0 if none remain.
    void robotRemoved(usar::RobotId id, const QString& name, usar::RobotId instead);
    void robotLinkChanged(usar::RobotId id);
    void linkUpdated(std::shared_ptr<const usar::mission::SessionUpdate> update); ///< the spare connection's
    void robotUpdated(usar::RobotId id, std::shared_ptr<const usar::mission::SessionUpdate> update);
    void restBegun(usar::RobotId id); ///< the behavior of `flyRest` was started
    void behaviorFinished(usar::RobotId id, bool success, const QString& reason);
    /// The behavior threw, hung or died, as `text` says; `startAgain` may help. Replaces `noticed`; same kind of `key`.
    void behaviorBroke(usar::RobotId id, const QString& key, const QString& text);
    void resultsWritten(usar::RobotId id, const usar::mission::RunSummary& summary, const QString& robot_name);
    void exportFailed(usar::RobotId id, const QString& reason); ///< the scan is still in memory
    void savingChanged(const QString& robot_name);              ///< whose scan is being written now; empty: none is
    void mapExported(const QStringList& files, const QString& robot_name); ///< full paths
    void noticed(const QString& key, const usar::mission::Notice& notice); ///< `key` groups repeats, for a cure
    void cured(const QString& key);
    void readyToClose();

protected:
    void note(Severity severity, const QString& key, const QString& text);
    void endSessions(); ///< at once and without saving, for an owner whose server ends next

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

} // namespace usar::mission
