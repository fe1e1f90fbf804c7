// The behavior "airrobot/posh": the terrain survey controlled by a POSH plan, with the same SurveyFlight as the state
// machine.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/agent/posh_registry.h"
#include "core/agent/robot_plugin.h"

namespace usar::airrobot {

/// The senses and acts of the AirRobot by their names in plans (thesis 4.3).
const agent::PoshRegistry& surveyRegistry();
/// The plan that comes with the robot: resources/plans/airrobot.lap.
agent::PlanText surveyPlan();
/// Uses the plan in the context, or surveyPlan if it has none. Fails if the plan cannot run on this robot.
Result<std::unique_ptr<agent::Behavior>> makePlannedSurvey(agent::BehaviorContext context);

} // namespace usar::airrobot
