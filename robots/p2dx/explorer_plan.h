// "p2dx/posh": the same robot, decided by a POSH plan over the same senses and acts.
#pragma once

#include <memory>

#include "core/agent/posh_registry.h"
#include "core/agent/robot_plugin.h"

namespace usar::p2dx {

/// Senses and acts of the P2DX, as plans name them.
const agent::PoshRegistry& explorerRegistry();
/// The plan that comes with the robot: resources/plans/p2dx.lap.
agent::PlanText explorerPlan();
/// An error where the plan cannot run on this robot.
Result<std::unique_ptr<agent::Behavior>> makePlannedExplorer(agent::BehaviorContext context);

} // namespace usar::p2dx
