// The P2DX and its behaviors, separate from the plugin class so that tests can link them. The classes of the
// behaviors are in the source file, because nothing else makes them.
#pragma once

#include "core/agent/listed_robot.h"

namespace usar::p2dx {

/// The behaviors "p2dx/cpp" and "p2dx/posh": the same senses and acts, used by C++ or by a plan.
class P2dxRobot : public agent::ListedRobot {
public:
    P2dxRobot();
};

} // namespace usar::p2dx
