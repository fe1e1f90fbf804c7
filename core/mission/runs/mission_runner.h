// Runs one mission without a window: uses the same session code, reports progress by a signal, and ends with a summary.
#pragma once

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
#include "core/mission/runs/after_stop.h"
#include "core/mission/runs/run_options.h"
#include "core/mission/runs/run_summary.h"
#include "core/mission/session/robot_session.h"

namespace usar::mission {

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

/// The reason of a mission that a signal has ended.
inline constexpr char interrupted_reason[] = "Interrupted; what was scanned until then is kept.";

/// In the folder for temporary files: where results go that cannot be written into their own folder.
inline constexpr char shelter_name[] = "/USAR_Scan";

/// Exit codes of `usar-mission`.
enum ExitCode { Done = 0, MissionFailed = 1, BadInput = 2 };

/// Leads a RobotSession through connect, spawn, behavior and export. Whatever goes wrong on the way, what was scanned
/// is written, and `finished` is emitted once, from the event loop. Figures count up to the behavior's end; in a
/// simulator the robot is then watched a little longer (AfterStop). Before the robot moves, behavior, parameters, area
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
    enum class Phase { Idle, Connecting, Spawning, Flying, Watching, Over };

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
    /// Ends the mission, however far it came. Later calls only end the watch.
    void conclude(bool success, const std::string& reason, int exit_code);
    /// Writes the results and reports the end.
    void finish();
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
    AfterStop after_stop_;
    ScanRecord record_;     ///< at the end of the behavior
    RunSummary figures_;    ///< likewise
    QStringList unwritten_; ///< what could not be written where it should be, and why: sentences
    int exit_code_ = Done;
    QJsonObject summary_;
};

/// Returns a summary with the reason and whatever is known; a null pointer stands for what could not be read.
RunSummary refusedRun(const Error& error, const MissionOptions* options = nullptr, const Mission* mission = nullptr);

} // namespace usar::mission
