// Writes a mission to a file, so that it can be flown again.
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>

#include "core/mission/files/mission_file.h"

namespace usar::mission {

/// Returns JSON that `readMission` accepts, ending with a newline. Values in `mission` are in a behavior's units: those
/// whose spec says "rad" are written in degrees. Reading the text and converting the angles back gives the same
/// mission, except for reals with whole values, which the file cannot distinguish from integers and a behavior accepts
/// as either. The path of a plan is written as an absolute path, or as a relative one if it is inside `folder`, the
/// folder of the mission.
QByteArray writeMission(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                        const QString& folder = {});

/// Writes the mission file completely or not at all; an error names path and reason.
Result<void> writeMissionFile(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                              const QString& path);

} // namespace usar::mission
