// Where in a campaign's file an error comes from that is only found when its missions, worlds and faults are looked at.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/campaign/plan/campaign.h"
#include "core/campaign/plan/planned_run.h"

namespace usar::campaign {

/// Returns the error with the place of the first of these paths that the file has ("variants[1].behavior") as its
/// `where`; the former `where` moves into the text. Unchanged if the file has none of them, or was never read.
Error atPlace(const Campaign& campaign, const std::vector<std::string>& paths, Error error);

/// The same for an error of a run's mission. Unchanged if it already names a place in the mission's own file.
Error ofRun(const Campaign& campaign, const PlannedRun& run, Error error);

} // namespace usar::campaign
