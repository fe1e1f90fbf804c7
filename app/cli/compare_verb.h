// The verb of usar-mission that compares what campaigns have flown.
#pragma once

#include <QStringList>

namespace usar::app {

/// Runs `compare` with its arguments, which begin with the verb, and returns the program's exit code.
int runCompareVerb(const QStringList& arguments);

} // namespace usar::app
