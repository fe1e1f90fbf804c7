// A mission written down, so that it can be flown again.
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>

#include "core/mission/mission_file.h"

namespace usar::mission {

/// JSON that `readMission` takes, ending in a newline. Values of `mission` are as a behavior takes them: those whose
/// spec says "rad" are written in degrees. Reading it and turning the angles back gives the same mission, apart from
/// whole reals, which the file cannot tell from integers and a behavior takes as either. The path of a plan is
/// absolute, or relative where it lies in `folder`, the mission's.
QByteArray writeMission(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                        const QString& folder = {});

/// The file is written whole or not at all; an error names path and reason.
Result<void> writeMissionFile(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                              const QString& path);

} // namespace usar::mission
