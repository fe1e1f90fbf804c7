// The verbs of usar-mission for recordings: replaying them, and converting them to text and back.
#pragma once

#include <QStringList>

namespace usar::app {

/// Runs the verb that `arguments` begin with. Returns the program's exit code; errors go to standard error.
int runReplayVerb(const QStringList& arguments);

} // namespace usar::app
