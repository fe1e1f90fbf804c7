// A folder of tests: missions that claim something, flown as one campaign.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "core/campaign/plan/campaign.h"

namespace usar::campaign {

/// The name of the only variant of such a campaign.
inline constexpr char tests_variant[] = "tests";

/// Makes a campaign of the mission files (*.json) in the folder, in the order of their names. Each is flown once, with
/// the seed that it names, or 1. Fails if the folder has none, and on a mission that cannot be read or claims nothing.
Result<Campaign> campaignOfTests(const QString& folder);

} // namespace usar::campaign
