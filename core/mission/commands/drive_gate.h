// Limits DRIVE commands to the rate that a server can take.
#pragma once

#include <optional>
#include <vector>

#include "core/agent/command_port.h"
#include "core/base/clock.h"

namespace usar::mission {

/// Passes at most one DRIVE of each kind (and of each joint) per 50 ms of protocol time (protocol.md 9.2: about 20
/// Hz) and keeps only the newest meanwhile. Terms that a newer command leaves out are taken from the one that it
/// replaces, because a server keeps them too; an AckermannDrive is completed from all earlier ones, because UDK accepts
/// it only complete.
class DriveGate {
public:
    static constexpr Seconds spacing{0.05};

    /// Queues the command. Returns true if it replaced one that had not been sent yet.
    bool offer(agent::CausedCommand drive);
    /// Takes out the commands to send now, oldest first; empty if their time has not come. If the clock ran backward (a
    /// new connection) or `at_once` is set, the commands are released without waiting.
    std::vector<agent::CausedCommand> release(Seconds now, bool at_once = false);
    /// Drops all queued commands; the next one may be sent at once.
    void reset() { *this = {}; }

private:
    void complete(protocol::Command& drive);

    std::vector<agent::CausedCommand> held_;
    std::optional<Seconds> last_sent_;
    std::optional<protocol::Command> last_ackermann_;
};

} // namespace usar::mission
