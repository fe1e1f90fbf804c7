// The name of a robot, for texts in the window.
#pragma once

#include <QString>

#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// Returns the name that the robot was spawned with, as in the protocol.
inline QString nameOf(const Robot& robot) {
    return QString::fromStdString(robot.view().spawn.robot_name);
}

} // namespace usar::mission
