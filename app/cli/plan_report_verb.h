// `usar-mission plan-report [--json] FILE…`: reports on the runs of POSH plans in recordings and trace files.
#pragma once

#include <QStringList>

namespace usar::app {

/// Runs the verb; `arguments` begin with it. With --json the report consists of JSON lines. Returns 0 if all files
/// could be read, 2 if one could not or the call is wrong; that is reported on standard error, and the other files are
/// still included.
int runPlanReportVerb(const QStringList& arguments);

} // namespace usar::app
