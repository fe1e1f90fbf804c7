// All robots of a person: their sessions, behaviors, recordings and results, on whatever server they are.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/robot.h"
#include "core/mission/session/run_summary.h"

namespace usar::mission {

/// Notification key for the end of this robot's behavior.
inline QString missionKey(int id) {
    return QString("mission-%1").arg(id);
}

/// Owns the plugins, the robots' sessions and the keeper of scans; lives in the GUI thread and never waits in it. One
/// connection speaks for one robot, so a further one is kept open for the robot that is spawned next: it learns the
/// start poses, and its state is the state of the link.
class Fleet : public QObject {
    Q_OBJECT
public:
    /// `behavior_host`: path of the program that behaviors and plugins in a process of their own run in.
    explicit Fleet(const QString& behavior_host, QObject* parent = nullptr);
    ~Fleet() override;

    /// Before a scan: those plugins, by name, have a process of their own. `marks_folder` is where it is remembered
    /// which one ended the program.
    void isolatePlugins(const QStringList& names, const QString& marks_folder);
    /// What answers after a scan follows in `pluginsChanged`.
    agent::PluginLoader& plugins();
    const agent::PluginLoader& plugins() const;

    /// Opens the connection that waits for its robot. `lockstep`: ask the server to wait for us.
    void openLink(const QString& host, quint16 port, bool lockstep);
    /// Removes all robots but replays, and closes the connection that waits.
    void disconnectFromServer();
    const QString& level() const;
    /// Where robots can be spawned; empty until the server has told.
    const std::vector<protocol::StartPose>& startPoses() const;
    void setWorldExtent(const Rectangle& extent_in_map); ///< empty: unknown, as after `disconnectFromServer`
    /// The server's time is stopped on purpose, or runs again; for later connections, too.
    void expectSilence(bool expected);
    /// Something was made to fail, or works again: each robot on the server notes it.
    void noteFault(const QString& sentence);
    /// For the summary of the robot with this name; kept until the robot goes.
    void setTruth(const std::string& robot_name, const TrueFigures& truth);
    void setSeed(std::optional<std::uint64_t> seed); ///< for summaries; forgotten by `disconnectFromServer`

    QString nextRobotName() const;
    /// Next free key 1-9; an error where all are taken or there is no link.
    Result<int> spawn(SpawnRequest request);
    Robot* robot(int id) const;
    std::vector<Robot*> robots() const;
    /// RobotView::connection of a robot, or with 0 of the session that waits for one; 0 where there is none.
    int connectionOf(int id) const;
    Result<void> checkLine(int connection) const; ///< whether a line can be sent there now; else why not
    Result<void> sendLine(int connection, const QString& line, const std::string& source); ///< as it is
    /// The robot stops and its connection closes; what it scanned is saved.
    void remove(int id);
    /// For a robot that never came, or went with a lost link: INIT anew, as it was asked for the first time.
    void spawnAgain(int id);
    /// `plan_path`: of a person's own POSH plan; empty: the robot's. `isolate`: in a process of its own.
    Result<void> startBehavior(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                               const std::map<std::string, agent::ParameterValue>& values, const QString& plan_path,
                               bool isolate = false);
    /// What the robot did when its behavior broke: the same, with the same parameters, area and plan, in a process of
    /// its own.
    Result<void> startAgain(int id);
    Result<std::map<std::string, agent::ParameterValue>> prepareMission(const Mission& mission) const; ///< checkMission
    void stopAll();
    /// What the behavior would do with this task, before it starts. `id` may be 0: then from the map's origin. Told at
    /// once or later, as PluginLoader does.
    void preview(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                 const std::map<std::string, agent::ParameterValue>& values,
                 const agent::PluginLoader::Told& told) const;

    void setResultFolder(const QString& folder);
    QString resultFolder() const;
    bool resultFolderChosen() const;
    bool anythingToSave() const;
    void exportResults(int id);
    /// Every robot that is live, and each that comes, into a file of its own in the result folder. On at first.
    void setRecording(bool on);
    bool recording() const;
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
    bool closing() const;
    void stayOpen(); ///< the person changed their mind
    void cure(const QString& key) { emit cured(key); }

signals:
    /// Of what has answered.
    void pluginsChanged(const std::vector<usar::agent::PluginChange>& changes);
    void linkChanged(const usar::link::LinkStatus& status);
    /// The connection that waits is there, and `linkChanged` was told: a robot can be spawned.
    void nextConnected();
    /// By `disconnectFromServer`, before `linkChanged`: nobody needs the server any more.
    void serverLeft();
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
    void exportFailed(int id, const QString& reason); ///< the scan is still in memory
    /// `key` groups repeats and lets a cure clear them.
    void noticed(const QString& key, const usar::mission::Notice& notice);
    void cured(const QString& key);
    void readyToClose();

protected:
    void note(Severity severity, const QString& key, const QString& text);
    /// Ends all sessions at once and saves nothing, for an owner whose server ends next.
    void endSessions();

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

} // namespace usar::mission
