#include "app/cli/lines_verb.h"

#include <cstdio>

#include <QFile>

#include "app/cli/verb_complaint.h"
#include "core/mission/files/report_options.h"
#include "core/mission/reports/line_report.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

int runLinesVerb(const QStringList& arguments) {
    const auto file = mission::readLinesFile(arguments);
    if (!file)
        return complain(file.error());
    QFile input(*file);
    const bool opened = *file == "-" ? input.open(stdin, QIODevice::ReadOnly) : input.open(QIODevice::ReadOnly);
    if (!opened)
        return complain({input.errorString().toStdString(), file->toStdString(), "Check the name"});
    QFile output;
    if (!output.open(stdout, QIODevice::WriteOnly))
        return complain({output.errorString().toStdString(), "standard output", "Give it somewhere to go"});
    const auto counts = mission::reportLines(input, output);
    if (!counts)
        return complain(counts.error());
    return counts->with_diagnostics > 0 ? 1 : 0;
}

} // namespace usar::app
