#include "core/server/embedded/server_target.h"

#include "core/server/embedded/simulator_files.h"
#include "core/server/embedded/simulator_settings.h"

namespace usar::server {

namespace {

Result<void> readServer(const QString& text, ServerTarget& server) {
    const int colon = static_cast<int>(text.lastIndexOf(':'));
    if (colon <= 0)
        return failure("\"" + text.toStdString() + "\" is no host and port", "--connect", "Write host:port");
    QString host = text.left(colon);
    const bool bracketed = host.startsWith('[') && host.endsWith(']');
    if (host.contains(':') && !bracketed)
        return failure("\"" + text.toStdString() + "\" may mean more than one host and port", "--connect",
                       "Put an IPv6 address in brackets: [" + host.toStdString() +
                           "]:" + text.mid(colon + 1).toStdString());
    if (bracketed)
        host = host.mid(1, host.size() - 2);
    const auto port = readPort(text.mid(colon + 1), "connect");
    if (!port)
        return tl::unexpected(port.error());
    server.embedded = false;
    server.host = host;
    server.port = *port;
    return {};
}

Result<void> readSimulator(const QCommandLineParser& parser, ServerTarget& server) {
    bool ok = false;
    server.simulator.world = parser.value("world");
    server.simulator.seed = parser.value("seed").toULongLong(&ok);
    if (!ok)
        return failure("\"" + parser.value("seed").toStdString() + "\" is no seed", "--seed", "Give a whole number");
    for (const auto& [option, number] :
         {std::pair("port", &server.simulator.port), std::pair("wireless-port", &server.simulator.channels.wireless)}) {
        const auto port = readPort(parser.value(option), option);
        if (!port)
            return tl::unexpected(port.error());
        *number = *port;
    }
    auto access = readAccess(parser);
    if (!access)
        return tl::unexpected(access.error());
    server.simulator.access = *std::move(access);
    const auto battery = readBattery(parser.value("battery"));
    if (!battery)
        return tl::unexpected(battery.error());
    server.simulator.battery_life = *battery;
    auto faults = readFaults(parser.values("fault"));
    if (!faults)
        return tl::unexpected(faults.error());
    server.simulator.faults = *std::move(faults);
    return {};
}

} // namespace

QList<QCommandLineOption> serverOptions() {
    const ServerTarget usual;
    return sharedOptions() +
           QList<QCommandLineOption>{
               {"connect", "a USARSim server instead of the embedded simulator", "HOST:PORT"},
               {"world", "world of the embedded simulator", "NAME|FOLDER", "tall_test"},
               {"seed", "seed of the embedded simulator", "N", "1"},
               {"fault", "fault to inject into the embedded simulator; repeat for more. usar-sim --help lists them",
                "TEXT"},
               {"port", "port of the embedded simulator", "N", QString::number(usual.port)},
               {"wireless-port", "port of the wireless server, embedded or beside a USARSim server", "N",
                QString::number(usual.simulator.channels.wireless)}};
}

Result<ServerTarget> readServerTarget(const QCommandLineParser& parser) {
    ServerTarget server;
    if (const auto read = readSimulator(parser, server); !read)
        return tl::unexpected(read.error());
    if (parser.isSet("connect"))
        if (const auto read = readServer(parser.value("connect"), server); !read)
            return tl::unexpected(read.error());
    return server;
}

} // namespace usar::server
