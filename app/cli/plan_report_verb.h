// `usar-mission plan-report FILE…`: recordings and traces of POSH plans in, what their runs came to out.
#pragma once

#include <QStringList>

namespace usar::app {

/// `arguments` begin with the verb; `--json` among them asks for JSON lines. 0 where all files could be read, 2 where
/// one could not; that is told on standard error, and the others are reported all the same.
int runPlanReportVerb(const QStringList& arguments);

} // namespace usar::app
