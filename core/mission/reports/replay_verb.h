// The verbs of usar-mission for recordings: `replay` plays one, the others convert it to text and back, or to MCAP.
#pragma once

#include "core/mission/reports/verbs.h"
#include "core/mission/runs/replay_runner.h"

namespace usar::mission {

/// Called before a replay starts, so that the caller can connect what interrupts it.
using PrepareReplay = std::function<void(ReplayRunner& runner)>;

/// Runs the verb that `arguments` begin with and returns the program's exit code. A replay runs an
/// event loop until it ends, tells its progress on a terminal's standard error, and prints its summary as a line of
/// JSON.
int runReplayVerb(const QStringList& arguments, const VerbStreams& streams, const PrepareReplay& prepare);

} // namespace usar::mission
