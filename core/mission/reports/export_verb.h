// The verb `export` of usar-mission: writes a finished map in other formats.
#pragma once

#include <QStringList>

#include "core/mission/reports/verbs.h"

namespace usar::mission {

/// True for "export".
bool isExportVerb(const QString& word);
/// Runs the verb that `arguments` begin with and returns the program's exit code. Prints a line of
/// JSON: `success`, `reason` and `files`, with full paths. Needs an application, because a recording is played in an
/// event loop.
int runExportVerb(const QStringList& arguments, const VerbStreams& streams);

} // namespace usar::mission
