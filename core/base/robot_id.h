// The ids of robots and of the connections that serve them.
#pragma once

#include "core/base/id.h"

namespace usar {

/// A robot of the window: 1 to 9, the key that selects it. 0 stands for no robot, or for the one that is spawned next.
using RobotId = Id<struct RobotTag, 0>;
/// The connection that serves one robot, live or of a recording: unique while the program runs. 0 stands for none.
using ConnectionId = Id<struct ConnectionTag, 0>;

} // namespace usar
