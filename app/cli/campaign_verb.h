// The verb of usar-mission that flies a campaign.
#pragma once

#include <QStringList>

namespace usar::app {

/// Runs `campaign` with its arguments, which begin with the verb, in an event loop of its own, and returns the
/// program's exit code.
int runCampaignVerb(const QStringList& arguments);

} // namespace usar::app
