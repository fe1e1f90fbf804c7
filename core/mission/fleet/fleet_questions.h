// Questions about the robots of a fleet that several parts of the window ask.
#pragma once

#include <string>
#include <vector>

#include <QStringList>

#include "core/mission/fleet/robot.h"

namespace usar::mission {

using Robots = std::vector<Robot*>;

/// Names of all robots on the server; replays are left out.
QStringList liveNames(const Robots& robots);
/// True if a behavior of ours runs on any robot.
bool anyRunning(const Robots& robots);
/// True if a running plan of ours stands still.
bool anyHalted(const Robots& robots);
/// Gives an order to each behavior of ours that runs.
void orderAll(const Robots& robots, agent::Order order);
/// Continues all plans that stand still, or lets them run for one cycle.
void controlHalted(const Robots& robots, agent::PlanStep step);
/// A robot whose behavior broke and was not started again, preferably `first`, which may be null; null: none.
const Robot* brokenRobot(const Robots& robots, const Robot* first);
/// A live robot of this class for a mission: `first` if it fits, or else one that has nothing to do; null: none.
const Robot* robotFor(const Robots& robots, const Robot* first, const std::string& robot_class);

} // namespace usar::mission
