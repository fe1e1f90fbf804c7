#include "core/server/embedded/simulator_program.h"

#include <cstdio>
#include <utility>

#include <QCoreApplication>

#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::server {

namespace {

void tellClients(SimulatorServer& server, quint16 port, quint16 image_port) {
    const Access& access = server.access();
    const std::string host = access.address().toString().toStdString();
    std::printf("%s on %s - connect a USARSim client there, or: nc -C %s %u; Ctrl+C ends\n",
                server.simulation().world().name.c_str(), endpointText(access.address(), port).toUtf8().constData(),
                host.c_str(), static_cast<unsigned>(port));
    std::printf("Pictures of its cameras on %s\n", endpointText(access.address(), image_port).toUtf8().constData());
    if (access.isOpen())
        std::printf("Open to this machine and to %s; nothing that they send is checked for who sent it\n",
                    access.networks().toUtf8().constData());
    for (const sim::Simulation::Orphan& robot : server.simulation().orphans())
        std::printf("%s %s waits, and time with it, for a client that says INIT with its name\n",
                    robot.class_name.c_str(), robot.name.c_str());
    std::fflush(stdout);
}

} // namespace

Result<int> runSimulator(const SimulatorSettings& settings, std::unique_ptr<sim::Simulation> simulation,
                         const std::function<void(const QString& sentence)>& say) {
    SimulatorServer server(std::move(simulation));
    QObject::connect(&server, &SimulatorServer::logged, say);
    QObject::connect(&server, &SimulatorServer::objectRefused, [say](const QString& name, const QString& reason) {
        say(QStringLiteral("could not place '%1': %2").arg(name, reason));
    });
    server.setAccess(settings.access);
    if (settings.lockstep_patience)
        server.setLockstepPatience(*settings.lockstep_patience);
    const auto port = server.listen(settings.port);
    if (!port)
        return tl::unexpected(port.error());
    server.setPace(settings.pace, settings.factor);
    const OpenChannels channels = openChannels(server, settings.channels, settings.images);
    for (const QString& sentence : channels.sentences)
        say(sentence);
    QuitSignals signals_; // Before clients are told: who starts the program for them may stop it at once.
    QObject::connect(&signals_, &QuitSignals::quit, qApp, &QCoreApplication::quit);
    tellClients(server, *port, channels.ports.image);
    const int exit_code = QCoreApplication::exec();
    server.simulation().sumUpLog();
    for (const std::string& sentence : server.simulation().takeLog())
        say(QString::fromStdString(sentence));
    if (settings.save.isEmpty())
        return exit_code;
    const auto saved = saveSnapshot(server.simulation(), settings.save);
    return saved ? Result<int>(exit_code) : tl::unexpected(saved.error());
}

} // namespace usar::server
