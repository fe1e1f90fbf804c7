// Private data and helpers of Fleet, shared by its source files.
#pragma once

#include <functional>

#include <QMap>
#include <QTimer>

#include "core/mission/fleet/fleet.h"
#include "core/mission/fleet/opening_replays.h"
#include "core/mission/fleet/rests.h"
#include "core/mission/fleet/roster.h"
#include "core/mission/fleet/scan_keeper.h"
#include "core/mission/fleet/start_check.h"

namespace usar::mission {

struct Fleet::Private {
    Private(Fleet& fleet, const QString& host_program);

    Robot* robotOn(ConnectionId connection) const; ///< nullptr if there is none
    /// Opens the connection on which the next robot will be spawned.
    void openNext();
    void connectRobot(Robot* robot);               ///< of either kind, live or of a recording
    void tell(Robot* robot, const Notice& notice); ///< passes the notice on to the user
    void linkMoved(Robot* robot);
    /// True figures and seed for a robot's results; empty for a replay.
    SimulatorFacts factsOf(const Robot& robot) const;
    Result<void> start(Robot& robot, const StartedBehavior& start);
    MissionSite site() const { return {plugins, place, start_poses}; }
    /// Starts the mission whose rest this robot is to fly, once the robot is there.
    void startRest(Robot& robot);
    void finished(Robot* robot, bool success, const QString& reason);
    void closeWhenSaved();

    void record(Robot& robot, const SpawnRequest& as);
    /// Opens the file as a robot that carries out `first`. `looks_back_on`: see RobotIdentity.
    void openReplay(const QString& path, ConnectionId looks_back_on, const ReplayOrder& first);
    void addReplay(std::unique_ptr<Robot> robot, const RecordingFacts& facts, const QString& complaint);

    Fleet& q;                    ///< the owner
    const QString behavior_host; ///< path of the program in which isolated behaviors run
    agent::PluginLoader plugins;
    ScanKeeper keeper;
    QTimer patience; ///< runs while the window waits to close; limits that wait
    QString host;
    quint16 port = 0;
    bool lockstep = false;
    QString equipment_advice; ///< see RobotSession
    StartPlace place;
    std::vector<protocol::StartPose> start_poses; ///< as the server last reported them
    Roster roster;
    std::unique_ptr<Robot> next; ///< connected, not spawned
    OpeningReplays opening;
    QMap<QString, QString> replay_titles; ///< by path: what a recording is wanted to be named after
    std::map<ConnectionId, Seconds>
        wanted_moments;                    ///< by connection: moment to look back on, once the file contains it
    std::map<RobotId, TrueFigures> truths; ///< by robot id
    Rests rests;
    std::optional<std::uint64_t> seed;
    std::function<Truth()> make_truth; ///< makes the heights of the embedded world; empty: none
    bool recording = true;             ///< new robots are recorded
    RecordingLimit recording_limit{};
    bool silence_expected = false;
    bool closing = false; ///< the window waits for recordings and scans to be saved
};

} // namespace usar::mission
