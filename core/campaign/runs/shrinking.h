// Makes a run that breaks an invariant smaller, so that a person sees which of its faults matter.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/campaign/plan/campaign.h"
#include "core/campaign/plan/planned_run.h"
#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

using FaultTexts = std::vector<std::string>;

/// Returns the faults that are left when none of them can be taken out alone without `still_breaks` becoming false. It
/// is called with fewer and fewer faults, and never with `faults` themselves, which must break. They stay in order.
FaultTexts shrunk(FaultTexts faults, const std::function<bool(const FaultTexts&)>& still_breaks);

/// The line of a file of known failures for `run`, which broke what `result` breaks.
KnownFailure knownFailure(const Campaign& campaign, const PlannedRun& run, const RunResult& result);

/// Flies the run as a campaign does, with `program`, the path of usar-mission, and says whether it breaks an invariant
/// and ends as `before` did: a run that hung must hang. It is flown twice if `before` was. `folder` is for its files,
/// which are removed. Waits with an event loop of its own.
bool breaksAsBefore(const Campaign& campaign, const PlannedRun& run, const RunResult& before, const QString& program,
                    const QString& folder);

} // namespace usar::campaign
