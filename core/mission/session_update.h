// What a session tells the rest of the program, by value.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/command_port.h"
#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/link/replay.h"
#include "core/mapping/height_map.h"
#include "core/mapping/profile.h"
#include "core/mission/control_state.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"
#include "core/protocol/traffic_counts.h"

namespace usar::mission {

/// Where INIT of this connection stands. Asked also while a new connection is made to ask on.
enum class SpawnState { None, Asked, Failed, Done };

/// Of a recording that is being written.
struct RecordingFigures {
    std::string path;
    Seconds elapsed{0.0};
    std::uint64_t bytes = 0;
};

/// Running figures of a session.
struct SessionFigures {
    Seconds now{0.0};        ///< protocol clock
    Seconds spawned_at{0.0}; ///< the robot's first word by the same clock; 0 until it is known
    std::uint64_t lines_received = 0;
    std::uint64_t lines_malformed = 0;
    std::uint64_t lines_overlong = 0;
    std::uint64_t lines_not_shown = 0; ///< left out of updates because too many came in a frame
    std::uint64_t steps_sent = 0;      ///< STEP of lockstep, among the commands
    std::uint64_t record_revision = 0; ///< see ScanRecord::revision
    double lines_per_second = 0.0;     ///< of wall time
    protocol::TrafficCounts traffic;   ///< of this connection, or of the last one
    protocol::TrafficRates rates;
    std::optional<protocol::Dialect> dialect; ///< of this connection; absent until the server has shown it
    bool lockstep = false;                    ///< the server waits for us after each tick
    SpawnState spawn = SpawnState::None;
    bool spawned = false; ///< spawn is Done
    bool behavior_running = false;
    ControlState control{};                    ///< who drives
    std::optional<RecordingFigures> recording; ///< absent: nothing is recorded
    std::optional<link::ReplayFigures> replay; ///< absent: live
};

/// What a replayed behavior was asked to do.
struct ReplayedTask {
    std::string behavior_id;
    Rectangle area_in_map;
};

/// A command as it went to the server.
struct SentCommand : agent::CausedCommand {
    std::string text{}; ///< the line on the wire
    LineNumber after{}; ///< the newest line that had come by then
    Seconds time{0.0};  ///< protocol clock
};

/// Everything that changed since the last frame.
struct SessionUpdate {
    /// All that was told before is void: a replay was wound back, and what follows is all there is now.
    bool rewound = false;
    std::optional<ReplayedTask> task;      ///< a replayed behavior has begun
    std::vector<protocol::InfoLine> lines; ///< the newest ones when more than 4000 came in a frame
    std::vector<SentCommand> commands;     ///< in order; `after` says where between the lines
    std::vector<agent::Published> published;
    std::vector<std::shared_ptr<const mapping::HeightTile>> tiles;
    std::optional<mapping::HeightRange> height_range;
    std::vector<Vec3> last_hits; ///< of the newest placed scan, map frame, NaN = no hit
    /// Mapped ground behind, under and ahead of the robot; absent while neither robot nor map has changed.
    std::optional<mapping::CourseProfile> ground;
    SessionFigures figures;
};

/// A sentence or two for the person, with how bad it is.
///
/// `topic` names the kind of trouble ("spawn", "silence", "sensors"): the same topic of the same robot is the same
/// trouble again. With `over` it has ended, and `text` says so or is empty.
struct Notice {
    Severity severity = Severity::Note;
    std::string text;
    std::string topic{};
    bool over = false;
    bool operator==(const Notice&) const = default;
};

} // namespace usar::mission
