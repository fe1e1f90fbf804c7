// Runs one mission without a window: the same session code, progress by signal, a summary.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QJsonObject>
#include <QObject>

#include "core/agent/plugin_loader.h"
#include "core/mission/mission_file.h"
#include "core/mission/mission_score.h"
#include "core/mission/robot_session.h"
#include "core/mission/run_summary.h"

namespace usar::mission {

/// When a run gives up. Wall time but for the last.
struct RunLimits {
    SessionLimits session;
    Seconds connect{8.0};     ///< no connection, or no start poses on it
    Seconds spawn{20.0};      ///< no robot, and the session did not say why
    Seconds stall{30.0};      ///< the protocol clock stands still
    Seconds flight{6 * 3600}; ///< protocol clock: no mission takes that long
};

struct RunOptions {
    QString host = "127.0.0.1";
    quint16 port = 3000;
    bool lockstep = true;   ///< ask for it; a real server does not answer
    std::uint64_t seed = 1; ///< told in the summary; the simulator was given it by whoever made it
    QString result_folder;  ///< empty: default
    QString recording;      ///< a new file for all that is heard and said; empty: none
    QString behavior_host;  ///< path of usar-behavior-host, for a mission that isolates its behavior
    RunLimits limits;

    // What only the maker of an embedded simulator knows; absent on a real server.
    std::optional<Truth> truth;
    std::optional<Rectangle> world_extent;
    /// Of our robot so far; asked once, before the connection closes.
    std::function<std::optional<TrueFigures>()> true_figures;
};

struct Progress {
    double percent = 0.0;
    Seconds now{0.0};                 ///< protocol clock
    std::optional<Seconds> time_left; ///< protocol clock
    double speed_x = 0.0;             ///< protocol seconds a wall second
    std::string state;
};

/// Exit codes of `usar-mission`.
enum ExitCode { Done = 0, MissionFailed = 1, BadInput = 2 };

/// Drives a RobotSession through connect, spawn, behavior and export; whatever goes wrong on the way, what was scanned
/// is written and `finished` comes once, from the event loop. Before the robot moves it checks behavior, parameters,
/// area and result folder. One run per object. Lives in the thread of its event loop; the plugins outlive it.
class MissionRunner : public QObject {
    Q_OBJECT
public:
    MissionRunner(Mission mission, const agent::PluginLoader& plugins, RunOptions options, QObject* parent = nullptr);
    ~MissionRunner() override;

    void start();
    /// Ctrl+C: stops the robot, keeps what was scanned.
    void interrupt();
    /// See RobotSession::noteFault; the summary has it, too.
    void noteFault(const QString& sentence);
    /// Keys of the JSON summary (README); valid after `finished`.
    const QJsonObject& summary() const;

signals:
    void progressed(const usar::mission::Progress& progress);
    void noticed(const usar::mission::Notice& notice);
    void finished(int exit_code);

private:
    struct Private;
    std::unique_ptr<Private> d_;
};

} // namespace usar::mission
