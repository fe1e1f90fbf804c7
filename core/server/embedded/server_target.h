// Which server the window uses, and the options of its command line that say so.
#pragma once

#include <QCommandLineParser>

#include "core/base/result.h"
#include "core/server/embedded/simulation_loader.h"

namespace usar::server {

/// The server to connect to: the embedded simulator, or a server at `host` and `port`.
struct ServerTarget {
    bool embedded = true;
    QString host = "127.0.0.1";
    quint16 port = protocol::usual_port::bot;
    SimulatorSpec simulator;
};

/// Those that say which server: --connect, and the options of the embedded simulator, with their help and defaults.
QList<QCommandLineOption> serverOptions();
/// Reads them from a parser that has parsed the command line. The error names the option that is wrong.
Result<ServerTarget> readServerTarget(const QCommandLineParser& parser);

} // namespace usar::server
