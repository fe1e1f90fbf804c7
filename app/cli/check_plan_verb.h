// `usar-mission check-plan [--robot NAME] FILE…`: checks POSH plans and prints one JSON object per finding.
#pragma once

#include <QStringList>

namespace usar::app {

/// Runs the verb; `arguments` begin with it. With --robot the plans are also checked against the robot's senses and
/// acts. Returns 0 if no plan has an error, 1 if one has, 2 if a file cannot be read or the call is wrong. A file that
/// cannot be read is reported on standard error, and the other files are still checked.
int runCheckPlanVerb(const QStringList& arguments);

} // namespace usar::app
