// How much ground a robot covers.
#pragma once

#include <vector>

#include "core/base/outline.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// The outlines of all solids that collide, as seen from above, in the frame of the base and with all joints at 0; they
/// overlap. From the collisions of the robot's file.
std::vector<Outline> footprintOf(const RobotModel& robot);

} // namespace usar::sim
