#include "app/cli/lines_verb.h"

#include <cstdio>

#include <QFile>

#include "app/cli/verb_complaint.h"
#include "core/mission/reports/line_report.h"
#include "core/mission/session/mission_runner.h"

namespace usar::app {

namespace {} // namespace

int runLinesVerb(const QStringList& arguments) {
    if (arguments.size() != 2 || (arguments[1].startsWith('-') && arguments[1] != "-"))
        return complain({"this is not how to call it", arguments.join(' ').toStdString(),
                         "Write usar-mission lines FILE, or - for standard input"});
    QFile input(arguments[1]);
    const bool opened = arguments[1] == "-" ? input.open(stdin, QIODevice::ReadOnly) : input.open(QIODevice::ReadOnly);
    if (!opened)
        return complain({input.errorString().toStdString(), arguments[1].toStdString(), "Check the name"});
    QFile output;
    if (!output.open(stdout, QIODevice::WriteOnly))
        return complain({output.errorString().toStdString(), "standard output", "Give it somewhere to go"});
    const auto counts = mission::reportLines(input, output);
    if (!counts)
        return complain(counts.error());
    return counts->with_diagnostics > 0 ? 1 : 0;
}

} // namespace usar::app
