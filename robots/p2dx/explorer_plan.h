// The behavior "p2dx/posh": the same robot, controlled by a POSH plan that uses the same senses and acts.
#pragma once

#include <memory>

#include "core/agent/posh_registry.h"
#include "core/agent/robot_plugin.h"

namespace usar::p2dx {

/// The senses and acts of the P2DX by their names in plans.
const agent::PoshRegistry& explorerRegistry();
/// The plan that comes with the robot: resources/plans/p2dx.lap.
agent::PlanText explorerPlan();
/// Uses the plan in the context, or explorerPlan if it has none. Fails if the plan cannot run on this robot.
Result<std::unique_ptr<agent::Behavior>> makePlannedExplorer(agent::BehaviorContext context);

} // namespace usar::p2dx
