// The settings of a simulation, and a saved moment of it: the settings and every input that it received until then.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/protocol/dialect.h"
#include "core/sim/faults/fault.h"
#include "core/sim/radio.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

struct SimulationOptions {
    std::uint64_t seed = 1;
    /// How the server speaks. UDK answers each query at once, sends each sensor on a line of its own and usually ticks
    /// every 0.1 s (protocol.md 7).
    protocol::Dialect profile = protocol::Dialect::Ut2004;
    Seconds tick{0.2};                            ///< message tick; 0.2 s is UT2004's
    int physics_steps_per_tick = 50;              ///< 250 Hz by default
    std::optional<Seconds> battery_life{};        ///< replaces what each robot's file says
    bool noise = true;                            ///< sensor noise and INS drift
    std::shared_ptr<const RobotCatalog> robots{}; ///< the classes that can be spawned; null: none
    std::vector<Fault> faults{};                  ///< scheduled from the start
    std::string world_source{};                   ///< name or folder that the world was loaded from, for snapshots
    RadioParameters radio{};
    /// Every input is kept in memory, about 3 MB for an hour of one robot, so that a snapshot can be made.
    bool keeps_journal = true;
    bool operator==(const SimulationOptions&) const = default;
};

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
    SimulationOptions options; ///< without the robots, which are read again
    std::uint64_t ticks = 0;   ///< message ticks made
    std::uint64_t digest = 0;  ///< covers robots, objects and all output up to that moment
    std::vector<JournalEntry> journal{};
    bool operator==(const Snapshot&) const = default;
};

/// The snapshot as a file: text, except for the bytes of clients, each preceded by their count (format:
/// resources/docs/snapshot-format.md).
std::string write(const Snapshot& snapshot);
/// Parses a snapshot file. An error names the line and what is wrong with it.
Result<Snapshot> readSnapshot(std::string_view file);

} // namespace usar::sim
