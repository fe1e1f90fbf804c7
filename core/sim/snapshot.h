// A moment of a simulation, to go on from: what it was made of, and all that it was told until then.
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

/// What came from outside, in order.
struct JournalEntry {
    enum class Kind : char {
        Connect = 'c',
        Disconnect = 'd',
        Receive = 'r',  ///< `bytes` of the client
        Release = 'l',  ///< from lockstep
        AddFault = 'f', ///< `bytes`: its text
        EndFault = 'e', ///< `client`: its number
        Resume = 'o'    ///< a snapshot was taken up here: every client has gone, its robot waits
    };
    Kind kind = Kind::Receive;
    std::uint64_t tick = 0; ///< so many ticks were made before
    std::uint32_t client = 0;
    std::string bytes{};
    bool operator==(const JournalEntry&) const = default;
};

/// The same inputs at the same ticks give the same bytes, so the inputs are the state: taking a snapshot up means to
/// live through the run again, some hundred times faster than it was, and `digest` tells whether it came out the same.
/// World and robot files must be those of the run.
struct Snapshot {
    std::string world; ///< name or folder, as whoever made the simulation found it
    std::uint64_t seed = 1;
    protocol::Dialect profile = protocol::Dialect::Ut2004;
    Seconds tick{0.2};
    int physics_steps_per_tick = 50;
    std::optional<Seconds> battery_life{};
    bool noise = true;
    std::vector<std::string> faults{}; ///< of the beginning
    std::uint64_t ticks = 0;
    std::uint64_t digest = 0;
    std::vector<JournalEntry> journal{};
    bool operator==(const Snapshot&) const = default;
};

/// A text file but for the bytes of clients, which stand behind their count (format:
/// resources/docs/snapshot-format.md).
std::string write(const Snapshot& snapshot);
/// Errors name the line and what should be there.
Result<Snapshot> readSnapshot(std::string_view file);

} // namespace usar::sim
