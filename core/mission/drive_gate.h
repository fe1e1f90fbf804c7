// Keeps DRIVE commands to the rate that a server can take.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "core/base/clock.h"

namespace usar::mission {

/// At most one DRIVE per 50 ms of protocol time (usarsim-protocol 9.2: about 20 Hz); the newest is kept. Terms that a
/// newer DRIVE of the same kind leaves out are taken from the one that it replaces, because a server keeps them too.
class DriveGate {
public:
    static constexpr Seconds spacing{0.05};

    static bool isDrive(const protocol::Command& command);
    void offer(agent::CausedCommand drive);
    /// The DRIVE to send now, if its time has come. A clock that ran backward (a new connection) opens the gate.
    std::optional<agent::CausedCommand> release(Seconds now);
    /// The same without waiting.
    std::optional<agent::CausedCommand> releaseNow(Seconds now);
    /// Nothing is held any more, and the next one may go at once.
    void reset() { *this = {}; }
    bool holding() const { return held_.has_value(); }

private:
    std::optional<agent::CausedCommand> held_;
    std::optional<Seconds> last_sent_;
};

} // namespace usar::mission
