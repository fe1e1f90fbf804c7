#include "app/window/options.h"

#include <QCommandLineParser>

#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"
#include "core/server/embedded/simulator_settings.h"

namespace usar::app {

namespace {

Result<void> readServer(const QString& text, ServerTarget& server) {
    const int colon = static_cast<int>(text.lastIndexOf(':'));
    if (colon <= 0)
        return failure("\"" + text.toStdString() + "\" is no host and port", "--connect", "Write host:port");
    const auto port = server::readPort(text.mid(colon + 1), "connect");
    if (!port)
        return tl::unexpected(port.error());
    server.embedded = false;
    server.host = text.left(colon);
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
        const auto port = server::readPort(parser.value(option), option);
        if (!port)
            return tl::unexpected(port.error());
        *number = *port;
    }
    auto faults = server::readFaults(parser.values("fault"));
    if (!faults)
        return tl::unexpected(faults.error());
    server.simulator.faults = *std::move(faults);
    return {};
}

} // namespace

Result<Options> readOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    const ServerTarget usual;
    parser.setApplicationDescription("Watch, drive and program robots in the USARSim simulator.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOptions(
        {{"connect", "A USARSim server instead of the embedded simulator.", "host:port"},
         {"world", "World of the embedded simulator: a name or a folder.", "world", "tall_test"},
         {"seed", "Seed of the embedded simulator.", "number", "1"},
         {"fault", "Something that goes wrong in the embedded simulator; usar-sim --help lists them.", "text"},
         {"port", "Port of the embedded simulator.", "port", QString::number(usual.port)},
         {"wireless-port", "Port of the wireless server, embedded or beside a USARSim server.", "port",
          QString::number(usual.simulator.channels.wireless)},
         {"out", "Folder for results.", "folder"},
         {"plugins", "Folder with robot plugins, besides those that come with the program.", "folder"},
         {"theme", "light or dark.", "theme"}});
    parser.addPositionalArgument("file",
                                 "A mission or a plan to open, a recording to replay, or a snapshot to go on from.",
                                 "[MISSION.json | PLAN.lap | RECORDING.usarrec | SNAPSHOT.usarsnap]");
    if (!parser.parse(arguments))
        return failure(parser.errorText().toStdString(), "", "Try --help");
    if (parser.isSet("help"))
        parser.showHelp();
    if (parser.isSet("version"))
        parser.showVersion();

    Options options;
    options.result_folder = parser.value("out");
    if (parser.isSet("plugins"))
        options.plugin_folders = server::pluginFolders() + parser.values("plugins");
    const QString file = parser.positionalArguments().value(0);
    (file.endsWith(".usarrec")    ? options.recording
     : file.endsWith(".usarsnap") ? options.server.simulator.snapshot
                                  : options.mission_file) = file;
    const QString theme = parser.value("theme");
    if (theme == "light")
        options.theme = widgets::Theme::Light;
    else if (theme == "dark")
        options.theme = widgets::Theme::Dark;
    else if (!theme.isEmpty())
        return failure("\"" + theme.toStdString() + "\" is no theme", "--theme", "Say light or dark");
    if (const auto read = readSimulator(parser, options.server); !read)
        return tl::unexpected(read.error());
    if (parser.isSet("connect"))
        if (const auto read = readServer(parser.value("connect"), options.server); !read)
            return tl::unexpected(read.error());
    return options;
}

} // namespace usar::app
