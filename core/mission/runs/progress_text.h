// Progress of a run as text for a terminal.
#pragma once

#include <optional>
#include <string>

#include "core/mission/runs/mission_runner.h"

namespace usar::mission {

/// Wall time until the end, from the behavior's own estimate, or else from the percentage so far; nullopt if neither
/// helps.
std::optional<Seconds> wallTimeLeft(const Progress& progress, Seconds wall_elapsed);

/// Formats a line such as "[########------------]  40 %  scanning lane 4 of 9  120x  ETA 0:12".
std::string progressLine(const Progress& progress, Seconds wall_elapsed);

/// Formats a duration as "1:02:03" or "2:03", rounded up to whole seconds.
std::string clockText(Seconds span);

} // namespace usar::mission
