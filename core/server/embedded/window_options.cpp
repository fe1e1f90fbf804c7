#include "core/server/embedded/window_options.h"

#include <QCommandLineParser>

#include "core/server/embedded/program_files.h"

namespace usar::server {

Result<WindowOptions> readWindowOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription("Watch, drive and program robots in the USARSim simulator.");
    parser.addHelpOption();
    parser.addVersionOption();
    addServerOptions(parser);
    parser.addOptions({{"out", "Folder for results.", "folder"},
                       {"plugins", "Folder with robot plugins, besides those that come with the program.", "folder"},
                       {"theme", "light, dark or system (as the desktop).", "theme"}});
    parser.addPositionalArgument("file",
                                 "A mission or a plan to open, a recording to replay, or a snapshot to continue from.",
                                 "[MISSION.json | PLAN.lap | RECORDING.usarrec | SNAPSHOT.usarsnap]");
    if (!parser.parse(arguments))
        return failure(parser.errorText().toStdString(), "", "Try --help");
    if (parser.isSet("help"))
        parser.showHelp();
    if (parser.isSet("version"))
        parser.showVersion();

    WindowOptions options;
    auto target = readServerTarget(parser);
    if (!target)
        return tl::unexpected(target.error());
    options.server = *std::move(target);
    options.result_folder = parser.value("out");
    if (parser.isSet("plugins"))
        options.plugin_folders = pluginFolders() + parser.values("plugins");
    const QString file = parser.positionalArguments().value(0);
    (file.endsWith(".usarrec")    ? options.recording
     : file.endsWith(".usarsnap") ? options.server.simulator.snapshot
                                  : options.mission_file) = file;
    options.theme = parser.value("theme");
    if (!QStringList{"", "light", "dark", "system"}.contains(options.theme))
        return failure("\"" + options.theme.toStdString() + "\" is no theme", "--theme", "Say light, dark or system");
    return options;
}

} // namespace usar::server
