// The ERS and its behaviors, separate from the plugin class so that tests can link them. The classes of the
// behaviors are in the source file, because nothing else makes them.
#pragma once

#include "core/agent/listed_robot.h"

namespace usar::ers {

/// The behavior "ers/cpp": it walks to a ball and kicks it.
class ErsRobot : public agent::ListedRobot {
public:
    ErsRobot();
};

} // namespace usar::ers
