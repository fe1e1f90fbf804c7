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
#include "core/mapping/height_map.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Running figures of a session.
struct SessionFigures {
    Seconds now{0.0};        ///< protocol clock
    Seconds spawned_at{0.0}; ///< the robot's first word by the same clock; 0 until it is known
    std::uint64_t lines_received = 0;
    std::uint64_t lines_malformed = 0;
    std::uint64_t lines_overlong = 0;
    double lines_per_second = 0.0; ///< of wall time
    bool lockstep = false;         ///< the server waits for us after each tick
    bool spawned = false;
    bool behavior_running = false;
};

/// Everything that changed since the last frame.
struct SessionUpdate {
    std::vector<protocol::InfoLine> lines;      ///< the newest ones when more than 1000 came in a frame
    std::vector<agent::CausedCommand> commands; ///< as they were sent
    std::vector<agent::Published> published;
    std::vector<std::shared_ptr<const mapping::HeightTile>> tiles;
    std::optional<mapping::HeightRange> height_range;
    std::vector<Vec3> last_hits; ///< of the newest placed scan, map frame, NaN = no hit
    SessionFigures figures;
};

/// A sentence or two for the person, with how bad it is.
struct Notice {
    Severity severity = Severity::Note;
    std::string text;
    bool operator==(const Notice&) const = default;
};

} // namespace usar::mission
