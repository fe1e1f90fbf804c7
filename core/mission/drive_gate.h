// Keeps DRIVE commands to the rate that a server can take.
#pragma once

#include <optional>
#include <vector>

#include "core/agent/command_port.h"
#include "core/base/clock.h"

namespace usar::mission {

/// At most one DRIVE of each kind (and of each joint) per 50 ms of protocol time (usarsim-protocol 9.2: about 20 Hz);
/// the newest is kept. Terms that a newer one leaves out are taken from the one that it replaces, because a server
/// keeps them too; an AckermannDrive is filled up from all that were said before, because UDK takes it only whole.
class DriveGate {
public:
    static constexpr Seconds spacing{0.05};

    /// DRIVE and MULTIDRIVE.
    static bool isDrive(const protocol::Command& command) { return protocol::isDrive(command); }
    /// True where it replaced one that had not been sent.
    bool offer(agent::CausedCommand drive);
    /// What to send now, the oldest first, if the time has come. A clock that ran backward (a new connection) opens the
    /// gate.
    std::vector<agent::CausedCommand> release(Seconds now);
    /// The same without waiting.
    std::vector<agent::CausedCommand> releaseNow(Seconds now);
    /// Nothing is held any more, and the next one may go at once.
    void reset() { *this = {}; }
    bool holding() const { return !held_.empty(); }

private:
    void complete(protocol::Command& drive);

    std::vector<agent::CausedCommand> held_;
    std::optional<Seconds> last_sent_;
    std::optional<protocol::Command> last_ackermann_;
};

} // namespace usar::mission
