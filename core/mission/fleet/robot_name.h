// What people call a robot.
#pragma once

#include <QString>

#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// The name it was spawned with, as it stands on the wire.
inline QString nameOf(const Robot& robot) {
    return QString::fromStdString(robot.view().spawn.robot_name);
}

} // namespace usar::mission
