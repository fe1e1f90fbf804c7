// Options of a mission that is flown without a window.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QString>

#include "core/agent/behavior_start.h"
#include "core/base/clock.h"
#include "core/link/in_process_socket.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/runs/mission_score.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/mission/runs/run_summary.h"
#include "core/mission/session/session_orders.h"
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

} // namespace usar::mission
