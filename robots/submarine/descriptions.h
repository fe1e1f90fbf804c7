// The Submarine and its behaviors, separate from the plugin class so that tests can link them. The classes of the
// behaviors are in the source file, because nothing else makes them.
#pragma once

#include "core/agent/listed_robot.h"

namespace usar::submarine {

/// The behavior "submarine/cpp": it follows the bottom of the sea.
class SubmarineRobot : public agent::ListedRobot {
public:
    SubmarineRobot();
};

} // namespace usar::submarine
