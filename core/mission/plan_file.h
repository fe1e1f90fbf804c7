// A POSH plan that a person keeps in a file.
#pragma once

#include <string>
#include <vector>

#include <QIODevice>
#include <QString>

#include "core/agent/robot_plugin.h"
#include "core/base/result.h"

namespace usar::mission {

/// All of it; of what is longer than any plan, or never ends, just so much that its reader says so.
std::string readPlanText(QIODevice& input);

/// The plan's name is the path. Refused where it cannot be opened; what is wrong with the plan itself is not looked at.
Result<agent::PlanText> readPlanFile(const QString& path);

/// The robot that goes by this name ("AirRobot"), class on the wire or behavior ("airrobot/posh"), in any case; the
/// error lists the names of those that plans can decide for.
Result<const agent::RobotDescription*> robotForPlans(const std::vector<agent::RobotDescription>& robots,
                                                     const QString& name);

} // namespace usar::mission
