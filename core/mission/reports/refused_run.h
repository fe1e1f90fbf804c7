// The summary of a run that was refused before it began.
#pragma once

#include "core/base/result.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/runs/run_summary.h"

namespace usar::mission {

/// The reason, and what is known of the run. Null: not even that could be read.
RunSummary refusedRun(const Error& error, const MissionOptions* options = nullptr, const Mission* mission = nullptr);

} // namespace usar::mission
