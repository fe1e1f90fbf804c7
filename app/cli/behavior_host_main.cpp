// usar-behavior-host: runs one behavior in a process of its own. It is started by mission-control and usar-mission,
// never by hand.
#include <cstdio>

#include <QCoreApplication>

#include "core/agent/process/behavior_service.h"
#include "core/base/version.h"

int main(int argc, char** argv) {
    if (usar::answersVersion(argc, argv))
        return 0;
    QCoreApplication application(argc, argv);
    bool ok = false;
    const int socket = QCoreApplication::arguments().value(1).toInt(&ok);
    if (ok && socket > 2)
        return usar::agent::serveBehavior(socket);
    std::fprintf(stderr, "usar-behavior-host runs a robot's behavior for mission-control and usar-mission, which start "
                         "it to run a behavior in a separate process (usar-mission run --isolate).\n");
    return 2;
}
