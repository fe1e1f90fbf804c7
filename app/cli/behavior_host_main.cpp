// usar-behavior-host: runs one behavior in a process of its own. It is started by mission-control and usar-mission,
// never by hand.
#include <cstdio>

#include <QCoreApplication>

#include "app/cli/behavior_host_program.h"
#include "core/agent/process/behavior_service.h"
#include "core/base/version.h"
#include "core/usage/help_text.h"

int main(int argc, char** argv) {
    if (usar::answersVersion(argc, argv))
        return 0;
    QCoreApplication application(argc, argv);
    const usar::usage::Program program = usar::app::behaviorHostProgram();
    if (const auto help = usar::usage::answerToHelp(program, QCoreApplication::arguments().mid(1))) {
        std::printf("%s", qPrintable(*help));
        return 0;
    }
    bool ok = false;
    const int socket = QCoreApplication::arguments().value(1).toInt(&ok);
    if (ok && socket > 2)
        return usar::agent::serveBehavior(socket);
    std::fprintf(stderr, "%s", qPrintable(usar::usage::helpText(program)));
    return 2;
}
