// usar-sim: runs the simulator alone, for any USARSim client.

#include <cstdio>

#include <QCommandLineParser>
#include <QCoreApplication>

#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"
#include "core/server/embedded/simulator_settings.h"
#include "core/server/simulator_server.h"

namespace {

int complain(const usar::Error& error) {
    std::fprintf(stderr, "usar-sim: %s\n", error.text().c_str());
    return 2;
}

void print(const QString& sentence) {
    std::fprintf(stderr, "%s\n", sentence.toLocal8Bit().constData());
}

void printLog(const usar::server::SimulatorServer& server) {
    using Server = usar::server::SimulatorServer;
    QObject::connect(&server, &Server::logged, print);
    QObject::connect(&server, &Server::objectRefused, [](const QString& name, const QString& reason) {
        print(QStringLiteral("could not place '%1': %2").arg(name, reason));
    });
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName("usar-sim");
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addVersionOption();
    parser.setApplicationDescription("Simulates a world for USARSim clients on loopback TCP.\n\n" +
                                     usar::server::faultHelp());
    usar::server::addSimulatorOptions(parser);
    if (!parser.parse(QCoreApplication::arguments()))
        return complain({parser.errorText().toStdString(), "", "See usar-sim --help"});
    if (parser.isSet("version"))
        parser.showVersion();
    if (parser.isSet("help"))
        parser.showHelp();
    const auto settings = usar::server::readSimulatorSettings(parser);
    if (!settings)
        return complain(settings.error());
    auto simulation = usar::server::makeSimulation(*settings, complain);
    if (!simulation)
        return complain(simulation.error());
    const std::string level = (*simulation)->world().name;

    usar::server::SimulatorServer server(std::move(*simulation));
    printLog(server);
    const auto port = server.listen(settings->port);
    if (!port)
        return complain(port.error());
    server.setPace(settings->pace, settings->factor);
    const usar::server::OpenChannels channels =
        usar::server::openChannels(server, settings->channels, settings->images);
    for (const QString& sentence : channels.sentences)
        print(sentence);
    std::printf("%s on 127.0.0.1:%u - connect a USARSim client there, or: nc -C 127.0.0.1 %u; Ctrl+C ends\n",
                level.c_str(), static_cast<unsigned>(*port), static_cast<unsigned>(*port));
    std::printf("Pictures of its cameras on 127.0.0.1:%u\n", static_cast<unsigned>(channels.ports.image));
    for (const usar::sim::Simulation::Orphan& robot : server.simulation().orphans())
        std::printf("%s %s waits, and time with it, for a client that says INIT with its name\n",
                    robot.class_name.c_str(), robot.name.c_str());
    std::fflush(stdout);

    usar::server::QuitSignals signals_;
    QObject::connect(&signals_, &usar::server::QuitSignals::quit, &application, &QCoreApplication::quit);
    const int exit_code = application.exec();
    if (settings->save.isEmpty())
        return exit_code;
    const auto saved = usar::server::saveSnapshot(server.simulation(), settings->save);
    return saved ? exit_code : complain(saved.error());
}
