// usar-sim: runs the simulator alone, for any USARSim client.

#include <cstdio>

#include <QCommandLineParser>
#include <QCoreApplication>

#include "core/base/version.h"
#include "core/server/embedded/simulator_files.h"
#include "core/server/embedded/simulator_program.h"
#include "core/usage/help_text.h"

namespace {

int complain(const usar::Error& error) {
    std::fprintf(stderr, "usar-sim: %s\n", error.text().c_str());
    return 2;
}

void print(const QString& sentence) {
    std::fprintf(stderr, "%s\n", sentence.toLocal8Bit().constData());
}

} // namespace

int main(int argc, char** argv) {
    if (usar::answersVersion(argc, argv))
        return 0;
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName("usar-sim");
    if (const auto help =
            usar::usage::answerToHelp(usar::server::simulatorProgram(), QCoreApplication::arguments().mid(1))) {
        std::printf("%s", qPrintable(*help));
        return 0;
    }
    QCommandLineParser parser;
    parser.addOptions(usar::server::simulatorOptions());
    if (!parser.parse(QCoreApplication::arguments()))
        return complain({parser.errorText().toStdString(), "", "See usar-sim --help"});
    const auto settings = usar::server::readSimulatorSettings(parser);
    if (!settings)
        return complain(settings.error());
    auto simulation = usar::server::makeSimulation(*settings, complain);
    if (!simulation)
        return complain(simulation.error());
    const auto exit_code = usar::server::runSimulator(*settings, *std::move(simulation), print);
    return exit_code ? *exit_code : complain(exit_code.error());
}
