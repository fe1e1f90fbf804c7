// What usar-mission does with recordings: replay, text and back.
#pragma once

#include <QStringList>

namespace usar::app {

/// `arguments` begin with the verb. The program's exit code; what is wrong goes to standard error.
int runReplayVerb(const QStringList& arguments);

} // namespace usar::app
