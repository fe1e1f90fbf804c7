// "airrobot/posh": the terrain survey decided by a POSH plan, over the same flight as the state machine.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/agent/posh_registry.h"
#include "core/agent/robot_plugin.h"

namespace usar::airrobot {

/// Senses and acts of the AirRobot, as plans name them (thesis 4.3).
const agent::PoshRegistry& surveyRegistry();
/// The plan that comes with the robot: resources/plans/airrobot.lap.
agent::PlanText surveyPlan();
/// An error where the plan cannot run on this robot.
Result<std::unique_ptr<agent::Behavior>> makePlannedSurvey(agent::BehaviorContext context);

} // namespace usar::airrobot
