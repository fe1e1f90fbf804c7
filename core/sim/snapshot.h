// A saved moment of a simulation: its settings and every input that it received until then.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/protocol/dialect.h"

namespace usar::sim {

/// One input of a run. Entries are in the order in which they happened.
struct JournalEntry {
    enum class Kind : char {
        Connect = 'c',
        Disconnect = 'd',
        Receive = 'r',  ///< `bytes` from the client
        Release = 'l',  ///< the client was released from lockstep
        AddFault = 'f', ///< `bytes` is the fault's text
        EndFault = 'e', ///< `client` is the fault's number
        Resume = 'o'    ///< a snapshot was resumed: all clients were gone and their robots waited for new ones
    };
    Kind kind = Kind::Receive;
    std::uint64_t tick = 0; ///< number of ticks made before it
    std::uint32_t client = 0;
    std::string bytes{};
    bool operator==(const JournalEntry&) const = default;
};

/// The same inputs at the same ticks give the same bytes, so the inputs are the state. Resuming a snapshot replays the
/// run, about a hundred times faster than the original, and `digest` tells whether it came out the same. The world and
/// robot files must be those of the run.
struct Snapshot {
    std::string world; ///< name or folder, from SimulationOptions::world_source
    std::uint64_t seed = 1;
    protocol::Dialect profile = protocol::Dialect::Ut2004;
    Seconds tick{0.2};
    int physics_steps_per_tick = 50;
    std::optional<Seconds> battery_life{};
    bool noise = true;
    std::vector<std::string> faults{}; ///< scheduled from the start, as text
    std::uint64_t ticks = 0;           ///< message ticks made
    std::uint64_t digest = 0;          ///< covers robots, objects and all output up to that moment
    std::vector<JournalEntry> journal{};
    bool operator==(const Snapshot&) const = default;
};

/// The snapshot as a file: text, except for the bytes of clients, each preceded by their count (format:
/// resources/docs/snapshot-format.md).
std::string write(const Snapshot& snapshot);
/// Parses a snapshot file. An error names the line and what is wrong with it.
Result<Snapshot> readSnapshot(std::string_view file);

} // namespace usar::sim
