// Reports of a session to the rest of the program, by value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/agent/command_port.h"
#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/link/replay.h"
#include "core/mapping/height_map.h"
#include "core/mapping/profile.h"
#include "core/mission/hand/control_state.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"
#include "core/protocol/traffic_counts.h"

namespace usar::mission {

/// State of the INIT of this connection. Asked also while a new connection is being made for it.
enum class SpawnState { None, Asked, Failed, Done };

/// Figures of a recording that is being written.
struct RecordingFigures {
    std::string path;
    Seconds elapsed{0.0};    ///< since the recording began
    std::uint64_t bytes = 0; ///< of all its parts so far
    RecordingLimit limit_bytes{};
};

/// Running figures of a session.
struct SessionFigures {
    Seconds now{0.0};        ///< protocol clock
    Seconds spawned_at{0.0}; ///< time of the robot's first message on that clock; 0 until it is known
    std::uint64_t lines_received = 0;
    std::uint64_t lines_malformed = 0; ///< with something wrong in them; what could be read is used
    std::uint64_t lines_overlong = 0;  ///< dropped, because they exceed the splitter's cap
    std::uint64_t lines_not_shown = 0; ///< lines and commands left out of updates because too many came in one frame
    std::uint64_t steps_sent = 0;      ///< STEP commands sent in lockstep
    std::uint64_t record_revision = 0; ///< see ScanRecord::revision
    double lines_per_second = 0.0;     ///< received, per second of wall time
    protocol::TrafficCounts traffic;   ///< of this connection, or of the last one
    protocol::TrafficRates rates;      ///< over about half a second of wall time
    std::optional<Seconds> round_trip; ///< to the server and back; absent: not connected, a replay, or not known yet
    std::optional<protocol::Dialect> dialect; ///< of this connection; absent until the server has shown it
    bool lockstep = false;                    ///< the server waits for us after each tick
    std::optional<double>
        battery_left_pct; ///< share of the most that the robot has reported, 0..100; absent: none reported
    SpawnState spawn = SpawnState::None;
    bool spawned = false; ///< spawn is Done
    bool silent = false;  ///< connected, but the robot has sent nothing for longer than SessionLimits::stale
    bool behavior_running = false;
    ControlState control{};                    ///< who drives
    std::optional<RecordingFigures> recording; ///< absent: nothing is recorded
    std::optional<link::ReplayFigures> replay; ///< absent: live
};

/// The task of a replayed behavior.
struct ReplayedTask {
    std::string behavior_id;
    /// In meters; empty if the task has no area.
    Rectangle area_in_map;
};

/// A command as it was sent to the server.
struct SentCommand : agent::CausedCommand {
    std::string text{}; ///< the line on the wire, without its line end
    LineNumber after{}; ///< newest info line received before it was sent
    Seconds time{0.0};  ///< protocol clock
};

/// Everything that changed since the last update.
struct SessionUpdate {
    /// Everything reported before is void: a replay was rewound, and this update contains all there is now.
    bool rewound = false;
    std::optional<ReplayedTask> task;      ///< set if a replayed behavior has begun; the newest, if several have
    std::size_t published_before_task = 0; ///< how many of `published` belong to earlier behaviors than `task`
    std::vector<protocol::InfoLine> lines; ///< only the newest 4000 if more came in one frame
    std::vector<SentCommand> commands;     ///< in order; `after` gives their place between the lines
    /// In the order in which the behavior published them.
    std::vector<agent::Published> published;
    std::vector<std::shared_ptr<const mapping::HeightTile>> tiles; ///< the map's changed tiles
    std::optional<mapping::HeightRange> height_range;              ///< of the whole map; absent: the map is empty
    /// The corrected path of the scan so far, from above, map frame; the same points until the next adjustment. Null:
    /// the map is not corrected.
    std::shared_ptr<const std::vector<Vec2>> corrected_path_m;
    std::vector<Vec3> last_hits; ///< of the newest placed scan, map frame, NaN = no hit
    /// Mapped ground behind, under and ahead of the robot; absent if neither robot nor map has changed.
    std::optional<mapping::CourseProfile> ground;
    SessionFigures figures;
};

/// A message of a sentence or two for the user, with its severity. `topic` names the kind of problem ("spawn",
/// "silence", "sensors"): the same topic for the same robot means the same problem again. `over`: the problem has
/// ended, and `text` says so or is empty.
struct Notice {
    Severity severity = Severity::Note;
    std::string text;
    std::string topic{};
    bool over = false;
    bool operator==(const Notice&) const = default;
};

/// Returns the newest message of a type in this update, or nullptr.
/// The pointer is valid as long as the update is.
template <class Message>
const Message* newest(const mission::SessionUpdate& update) {
    for (auto line = update.lines.rbegin(); line != update.lines.rend(); ++line)
        if (const auto* message = std::get_if<Message>(&line->message))
            return message;
    return nullptr;
}

/// Returns the newest value of a type that the behavior published in this update, or nullptr.
/// The pointer is valid as long as the update is.
template <class Value>
const Value* newestPublished(const mission::SessionUpdate& update) {
    for (auto value = update.published.rbegin(); value != update.published.rend(); ++value)
        if (const auto* found = std::get_if<Value>(&*value))
            return found;
    return nullptr;
}

} // namespace usar::mission
