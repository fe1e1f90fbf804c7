// Names that tell the missions of a campaign apart.
#pragma once

#include "core/campaign/plan/campaign.h"

namespace usar::campaign {

/// Gives a name to each mission that has none and whose file's name others have as well: what it has and not all of
/// them have (folder, worlds, draws, first seed) in parentheses behind the file's, "scan (in town, area.x -40 to 10)",
/// or where that says nothing, says too much or is another's name, too, a number: "scan 2".
void nameMissions(std::vector<CampaignMission>& missions);

} // namespace usar::campaign
