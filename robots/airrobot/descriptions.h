// Description and behaviors of the AirRobot, separate from the plugin class so that tests can link them.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::airrobot {

agent::RobotDescription describeAirRobot();
/// Fails for an id that describeAirRobot does not list, and for a plan that cannot run on this robot.
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);
/// Returns the lanes of a survey and its duration without obstacles and charging. Fails if no lanes fit into the area.
Result<agent::TaskPreview> previewSurvey(const agent::BehaviorContext& context);

} // namespace usar::airrobot
