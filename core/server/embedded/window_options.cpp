#include "core/server/embedded/window_options.h"

#include <QCommandLineParser>

#include "core/base/numbers.h"
#include "core/server/embedded/program_files.h"

namespace usar::server {

namespace {

QList<QCommandLineOption> windowOptions() {
    return serverOptions() +
           QList<QCommandLineOption>{
               {"out", "folder for results (USAR_Scan on the Desktop)", "FOLDER"},
               {"plugins", "robot plugins, besides those that come with the program; repeat for more", "FOLDER"},
               {"at", "moment of RECORDING to show, in seconds as the replay bar counts them (0)", "S"},
               {"select", "robot to select as soon as it is there, in a recording or live", "NAME"},
               {"theme", "colors; system: as the desktop (as last time)", "light|dark|system"},
               usage::helpOption(),
               usage::versionOption()};
}

/// What --at says of the recording.
Result<std::optional<Seconds>> momentOf(const QCommandLineParser& parser, const QString& recording) {
    if (!parser.isSet("at"))
        return std::nullopt;
    const auto seconds = readNumber(parser.value("at").toStdString());
    if (!seconds || !(*seconds >= 0.0))
        return failure("\"" + parser.value("at").toStdString() + "\" is no moment of a recording", "--at",
                       "Say seconds from 0 up, for example --at 312.4");
    if (recording.isEmpty())
        return failure("only a recording has moments", "--at", "Name a RECORDING.usarrec, too");
    return Seconds{*seconds};
}

} // namespace

usage::Program windowProgram() {
    return {
        .name = "mission-control",
        .title = "watch, drive and program robots in the USARSim simulator",
        .description = {"mission-control is the window of USAR Mission Control. It connects to its embedded "
                        "simulator or to a USARSim server, spawns robots there, drives them by hand or by a "
                        "behavior, maps what they scan, records every flight and replays it."},
        .verbs = {{.name = {},
                   .calls = {"mission-control [options] [MISSION.json | PLAN.lap | RECORDING.usarrec | "
                             "SNAPSHOT.usarsnap | WORLD.sdf | FOLDER]"},
                   .purpose = "Watch, drive and program robots in the USARSim simulator. A file opens at the start: "
                              "a mission, a plan, a recording to replay, a snapshot to continue from, or a world.",
                   .options = windowOptions(),
                   .notes = {"Qt's own options, such as -platform, are taken, too."},
                   .exit_codes = {{0, "the window was closed"}, {2, "bad use, or no display"}}}},
        .sections = {{.title = "Files",
                      .entries = {{"MISSION.json", "a mission: what flies where"},
                                  {"PLAN.lap", "a POSH plan"},
                                  {"RECORDING.usarrec", "every byte of a flight, with its time and cause"},
                                  {"SNAPSHOT.usarsnap", "a moment of the simulator"},
                                  {"FOLDER/world.sdf", "a world"}}},
                     {.title = "Examples",
                      .entries = {{"mission-control resources/missions/quick_scan.json",
                                   "open the quick scan, ready to be started"},
                                  {"mission-control --connect 10.0.0.5:3000", "use a USARSim server"},
                                  {"mission-control flight.usarrec --at 312.4 --select R1",
                                   "show this moment of a recording"}}}},
        .see_also = {"usar-mission", "usar-sim", "usar-behavior-host"}};
}

Result<WindowOptions> readWindowOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.addOptions(windowOptions());
    if (!parser.parse(arguments))
        return failure(parser.errorText().toStdString(), "", "Try --help");

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
    const auto at = momentOf(parser, options.recording);
    if (!at)
        return tl::unexpected(at.error());
    options.at = *at;
    options.select = parser.value("select");
    options.theme = parser.value("theme");
    if (!QStringList{"", "light", "dark", "system"}.contains(options.theme))
        return failure("\"" + options.theme.toStdString() + "\" is no theme", "--theme", "Say light, dark or system");
    return options;
}

} // namespace usar::server
