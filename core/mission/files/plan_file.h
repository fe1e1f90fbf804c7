// Reading of POSH plans from the user's files.
#pragma once

#include <string>
#include <vector>

#include <QIODevice>
#include <QString>

#include "core/agent/robot_plugin.h"
#include "core/base/result.h"

namespace usar::mission {

/// Reads the whole plan. If the input is longer than any plan, or never ends, reads only so much that the plan reader
/// reports it as too long.
std::string readPlanText(QIODevice& input);

/// Reads a plan file; the plan's name is the path. Fails if the file cannot be opened; the plan itself is not checked.
Result<agent::PlanText> readPlanFile(const QString& path);

/// Returns the robot with this name ("AirRobot"), class on the wire or behavior ("airrobot/posh"), regardless of case.
/// The error lists the names of the robots for which plans can decide. The result points into `robots`.
Result<const agent::RobotDescription*> robotForPlans(const std::vector<agent::RobotDescription>& robots,
                                                     const QString& name);

} // namespace usar::mission
