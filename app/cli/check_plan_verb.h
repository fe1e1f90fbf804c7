// `usar-mission check-plan [--robot NAME] FILE…`: POSH plans in, a JSON object for each finding out.
#pragma once

#include <QStringList>

namespace usar::app {

/// `arguments` begin with the verb. With a robot the plans are checked against its senses and acts, too. 0 where no
/// plan has an error, 1 where one has, 2 where a file cannot be read; what cannot be read is told on standard error,
/// and the other files are checked all the same.
int runCheckPlanVerb(const QStringList& arguments);

} // namespace usar::app
