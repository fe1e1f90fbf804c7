// What brings a robot of any kind to rest, so that none drives on when nobody holds its reins (no server has a
// watchdog).
#pragma once

#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/robot_state.h"

namespace usar::mission {

/// A zero DRIVE for the kind of vehicle. An unknown one (UDK's aerial vehicle does not say that it is one) gets both
/// that of the air and that of the ground; legged robots and static platforms have none, for they move by joints.
std::vector<protocol::Command> zeroDrives(protocol::VehicleKind kind);

/// What was set in motion on this connection. Joints that were sent to an angle stay where they are when they are told
/// to stop; those with a speed or a torque get the speed 0, and so do links of mission packages.
class MovingParts {
public:
    /// Every command that went out; raw lines too.
    void sent(const protocol::Command& command);
    /// One command for each thing that was set in motion.
    std::vector<protocol::Command> stops() const { return stops_; }
    void reset() { stops_.clear(); }

private:
    void remember(const protocol::Command& stop);

    std::vector<protocol::Command> stops_;
};

} // namespace usar::mission
