// What the AirRobot plugin offers, without the plugin: tests link this.
#pragma once

#include "core/agent/robot_plugin.h"

namespace usar::airrobot {

agent::RobotDescription describeAirRobot();
Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context);
/// The lanes that a survey would fly, and how long without obstacles and charging.
Result<agent::TaskPreview> previewSurvey(const agent::BehaviorContext& context);

} // namespace usar::airrobot
