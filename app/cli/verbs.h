// The verbs of usar-mission that fly no mission: they read files and recordings.
#pragma once

#include <optional>

#include <QStringList>

namespace usar::app {

/// Runs the verb that `arguments` begin with and returns the program's exit code; nullopt if it is none of these verbs.
/// Errors go to standard error.
std::optional<int> runVerb(const QStringList& arguments);

} // namespace usar::app
