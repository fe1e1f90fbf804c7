// Commands that bring a robot of any kind to rest, so that none drives on when nobody controls it (no server has a
// watchdog).
#pragma once

#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/robot_state.h"

namespace usar::mission {

/// Keeps track of what was set in motion on this connection. Joints that were sent to an angle stay where they are when
/// they are stopped; those with a speed or a torque get speed 0, and so do links of mission packages.
class MovingParts {
public:
    /// To be called with every command that was sent, including raw lines.
    void sent(const protocol::Command& command);
    /// Returns one stop command for each thing that was set in motion.
    std::vector<protocol::Command> stops() const { return stops_; }
    void reset() { stops_.clear(); }

private:
    void remember(const protocol::Command& stop);

    std::vector<protocol::Command> stops_;
};

} // namespace usar::mission
