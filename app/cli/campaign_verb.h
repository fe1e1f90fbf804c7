// The verb of usar-mission that flies a campaign.
#pragma once

#include <QStringList>

namespace usar::app {

/// True for "campaign".
bool isCampaignVerb(const QString& word);
/// Runs the verb that `arguments` begin with, in an event loop of its own, and returns the program's exit code.
int runCampaignVerb(const QStringList& arguments);

} // namespace usar::app
