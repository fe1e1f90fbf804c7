// The worlds and robots that come with the program, read for the embedded simulator.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "core/sim/robots/robot_reader.h"
#include "core/sim/world.h"

namespace usar::app {

/// By name, or from a folder.
Result<sim::World> loadWorld(const QString& name_or_folder);

/// What cannot be read is left out and said.
sim::RobotsRead loadRobots();

} // namespace usar::app
