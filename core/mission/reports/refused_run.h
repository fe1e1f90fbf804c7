// The summary of a run that was refused before it began.
#pragma once

#include "core/base/result.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/runs/run_summary.h"

namespace usar::mission {

/// Returns a summary with the reason and whatever is known about the run; a null pointer stands for an argument that
/// could not be read.
RunSummary refusedRun(const Error& error, const MissionOptions* options = nullptr, const Mission* mission = nullptr);

} // namespace usar::mission
