// The verb of usar-mission that flies one run after another for a campaign.
#pragma once

#include "app/cli/mission_flight.h"

namespace usar::app {

/// Flies the runs that lines of standard input ask for (campaign::RunRequest), each in a copy of this process, so that
/// a crash ends that run only. Returns the program's exit code when standard input ends, or at SIGTERM, which also ends
/// the run that is under way.
int runWorker(Preloaded& loaded);

} // namespace usar::app
