// `usar-mission lines FILE|-`: protocol lines in, a JSON object for each out.
#pragma once

#include <QStringList>

namespace usar::app {

/// `arguments` begin with the verb. 0 when every line was clean, 1 where there was a diagnostic, 2 where the file
/// cannot be read; what is wrong goes to standard error.
int runLinesVerb(const QStringList& arguments);

} // namespace usar::app
