// `usar-mission lines FILE|-`: reads protocol lines and prints one JSON object per line.
#pragma once

#include <QStringList>

namespace usar::app {

/// Runs the verb; `arguments` begin with it. Returns 0 if no line has a diagnostic, 1 if one has, 2 if the file cannot
/// be read or the call is wrong, with the reason on standard error.
int runLinesVerb(const QStringList& arguments);

} // namespace usar::app
