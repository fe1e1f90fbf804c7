// Progress of a run as text for a terminal.
#pragma once

#include <optional>
#include <string>

#include "core/mission/mission_runner.h"

namespace usar::mission {

/// Wall time until the end, from the behavior's own estimate, else from the percentage so far.
std::optional<Seconds> wallTimeLeft(const Progress& progress, Seconds wall_elapsed);

/// "[########------------]  40 %  scanning lane 4 of 9  120x  ETA 0:12"
std::string progressLine(const Progress& progress, Seconds wall_elapsed);

/// "1:02:03" or "2:03"; whole seconds.
std::string clockText(Seconds span);

} // namespace usar::mission
