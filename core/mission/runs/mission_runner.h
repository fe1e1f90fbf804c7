// Runs one mission without a window: uses the same session code, reports progress by a signal, and ends with a summary.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QElapsedTimer>
#include <QJsonObject>
#include <QObject>
#include <QTimer>

#include "core/agent/behavior_start.h"
#include "core/agent/plugins/plugin_loader.h"
#include "core/base/result.h"
#include "core/mission/files/mission_check.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/runs/mission_score.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/mission/runs/run_summary.h"
#include "core/mission/session/robot_session.h"
#include "core/protocol/usual_values.h"

namespace usar::mission {

/// Times after which a run is given up. Wall time, because a server that says nothing tells no other; the limit of the
/// flight is among those of the session.
struct RunLimits {
    SessionLimits session;
    Seconds connect{8.0}; ///< no connection, or no start poses from the server
    Seconds spawn{20.0};  ///< no robot, and the session gave no reason
    Seconds stall{30.0};  ///< the protocol clock stands still
};

/// Options of one run.
struct RunOptions {
    QString host = "127.0.0.1"; ///< used unless the server is in_process
    quint16 port = protocol::usual_port::bot;
    link::InProcessServer in_process{}; ///< an embedded simulator in this thread; empty: there is none
    bool lockstep = true;               ///< ask for it; a real server does not answer
    std::uint64_t seed = 1; ///< only reported in the summary; whoever created the simulator has given it the seed
    QString result_folder;  ///< empty: the default folder
    ResultFiles files = ResultFiles::Always;
    FormatList formats; ///< in which the map is written besides the usual files
    QString recording;  ///< new file that records everything sent and received; empty: none
    RecordingLimit recording_limit{};
    bool course = false; ///< the summary tells how the run went, see RunCourse
    agent::BehaviorThread behavior_thread = agent::BehaviorThread::Own; ///< Callers: one that hangs hangs all
    QString behavior_host;        ///< path of usar-behavior-host, needed by a mission that isolates its behavior
    std::string equipment_advice; ///< see RobotSession
    RunLimits limits;
    /// The run that this one continues: its map is taken over, and only its rest is flown. The mission is that of the
    /// recording, with the whole area. Null: a run of its own.
    std::shared_ptr<const RecordedScan> earlier;

    // Known only to the creator of an embedded simulator; absent on a real server.
    std::optional<Truth> truth;
    std::optional<Rectangle> world_extent; ///< meters, map frame
    std::optional<double> dry_above_m;     ///< see agent::Task
    /// True figures of our robot so far; called before the connection closes.
    std::function<std::optional<TrueFigures>()> true_figures;
};

/// Progress of a run, for display.
struct Progress {
    double percent = 0.0;                     ///< of the whole task, 0..100
    Seconds now{0.0};                         ///< protocol clock
    std::optional<Seconds> time_left;         ///< estimate on the protocol clock; absent: unknown
    std::optional<TimeRange> time_left_range; ///< its spread; absent: unknown
    double speed_x = 0.0;                     ///< protocol seconds per wall second; 0 before the flight
    std::string state;                        ///< in words: "scanning lane 4 of 9"

    // Absent before the flight.
    std::optional<double> coverage_pct; ///< share of the mission area whose height is known, 0..100
    std::optional<double> distance_m;   ///< as the robot estimates it
    std::optional<Seconds> elapsed;     ///< protocol clock, since the spawn
    std::optional<double> range_left_m; ///< distance until the battery's reserve is needed; absent: unknown
};

/// Exit codes of `usar-mission`.
enum ExitCode { Done = 0, MissionFailed = 1, BadInput = 2 };

/// Leads a RobotSession through connect, spawn, behavior and export. Whatever goes wrong on the way, what was scanned
/// is written, and `finished` is emitted once, from the event loop. Before the robot moves, behavior, parameters, area
/// and result folder are checked. One run per object. Runs in its owner's thread, which needs an event loop; the
/// plugins must outlive it.
class MissionRunner : public QObject {
    Q_OBJECT
public:
    MissionRunner(Mission mission, const agent::PluginLoader& plugins, RunOptions options);
    ~MissionRunner() override;

    void start(); ///< a mission that fails the checks ends with BadInput
    /// Ends the run (Ctrl+C): stops the robot and keeps what was scanned.
    void interrupt();
    /// Notes a fault as RobotSession::noteFault does; it also appears in the summary.
    void noteFault(const QString& sentence) { session_.noteFault(sentence.toStdString()); }
    /// Ends the run if this is its robot: it is gone from the simulator, which tells nothing on the connection.
    void robotVanished(const QString& name);
    /// Ends the run if this is its robot: the connection stands, but nothing comes through any more.
    void robotSilenced(const QString& name);
    /// The JSON summary; headless.md lists its keys. Valid after `finished`.
    const QJsonObject& summary() const { return summary_; }

signals:
    /// Emitted several times a second until the run ends.
    void progressed(const usar::mission::Progress& progress);
    void noticed(const usar::mission::Notice& notice);
    /// `exit_code` is an ExitCode.
    void finished(int exit_code);

private:
    enum class Phase { Idle, Connecting, Spawning, Flying, Over };

    Result<void> prepare();
    void takeStartPoses(const protocol::StartPoses& poses);
    void takeRobot();
    void look();
    /// Time since the spawn, on the protocol clock.
    Seconds flightTime() const;
    Progress progress() const;
    /// Takes over the earlier run's map; ends the run if it has nothing left to fly.
    void continueEarlier();
    /// The mission for the recording.
    std::string missionNote() const;
    void conclude(bool success, const std::string& reason, int exit_code);
    void judgeClaims(RunSummary& figures);
    RunSummary figuresOf(const ScanRecord& record);
    /// Writes the results, into the folder for temporary files if the disk has filled up since the check.
    Result<QStringList> save(const ScanRecord& record, const RunSummary& figures);

    Mission mission_;
    const agent::PluginLoader& plugins_;
    RunOptions options_;
    RobotSession session_;
    QTimer timer_{this};
    QElapsedTimer since_start_, since_spawn_, since_flight_, since_time_moved_;
    std::optional<PreparedBehavior> behavior_;
    Pose start_in_map_;
    Seconds last_now_{-1.0};
    Phase phase_ = Phase::Idle;
    QJsonObject summary_;
};

/// Returns a summary with the reason and whatever is known; a null pointer stands for what could not be read.
RunSummary refusedRun(const Error& error, const MissionOptions* options = nullptr, const Mission* mission = nullptr);

} // namespace usar::mission
