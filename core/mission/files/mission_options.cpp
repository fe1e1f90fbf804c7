#include "core/mission/files/mission_options.h"

#include <cstring>
#include <utility>

#include <QFileInfo>

#include "core/base/numbers.h"
#include "core/mission/files/command_line.h"
#include "core/mission/files/export_options.h"
#include "core/mission/files/mission_value.h"

namespace usar::mission {

namespace {

QList<QCommandLineOption> runOptions() {
    return {
        {"behavior", "another behavior than the file's, for example airrobot/cpp", "ID"},
        {"plan", "a POSH plan of your own for a behavior that a plan decides, such as airrobot/posh", "PLAN.lap"},
        {"seed", "noise and drift of the embedded simulator (the file's, or 1)", "N"},
        {"speed", "simulated seconds per second (max)", "N|max"},
        {"battery", "life of the robots' batteries in the embedded simulator, in seconds (a week)", "S"},
        {"limit",
         "give the mission up after this simulated time, such as 90min or 20h (the mission's limit_h, or never)",
         "TIME"},
        {"connect", "a USARSim server instead of the embedded simulator", "HOST:PORT"},
        {"out", "where the results go (USAR_Scan on the Desktop)", "DIR"},
        {"files", "which runs leave the map's files there: always, only a run that failed, or never (always)",
         "always|failed|never"},
        {"record", "every byte in and out, for replay (a new file, usually NAME.usarrec)", "FILE"},
        {"record-limit",
         "the most megabytes that --record keeps, at least 10: it is written in parts, and the oldest go (no limit)",
         "MB"},
        {"export", "the map also in these formats, such as tif,asc; usar-mission export --help lists them", "LIST"},
        {"continue",
         "the rest of a mission that was cut off: what its recording has scanned is kept, and only the area around "
         "the larger gaps is flown, with the same seed",
         "RECORDING"},
        {"fault",
         "a fault of the embedded simulator, for example 'wind speed=4 gust=1 from=60'; repeat for more. usar-sim "
         "--help lists them",
         "TEXT"},
        {"set", "another value than the file's, such as area.width=40 or parameters.scan_altitude_m=3; repeat for more",
         "KEY=VALUE"},
        {"plugins", "robot plugins, besides those that come with the program; repeat for more", "FOLDER"},
        {"course", "add to the summary how the coverage grew, and where the robot flew, collided and gave goals up"},
        {"one-thread",
         "the behavior has no thread of its own, which costs least; one that hangs then hangs the program"},
        {"adjust",
         "on: the map is corrected where strips overlap (the mission's adjust, or off); off: the thesis's map",
         "on|off"},
        {"isolate", "the behavior runs in a separate process, so that only that can crash"},
        usage::helpOption()};
}

/// "90s", "30min" or "20h"; seconds without a unit. Nothing unless it is above 0.
std::optional<Seconds> readTime(const QString& text) {
    struct Unit {
        const char* word;
        double seconds;
    };
    for (const Unit& unit : {Unit{"min", 60.0}, Unit{"h", 3600.0}, Unit{"s", 1.0}, Unit{"", 1.0}}) {
        if (!text.endsWith(QLatin1String(unit.word)))
            continue;
        const QString digits = text.chopped(static_cast<qsizetype>(std::strlen(unit.word)));
        const auto count = readNumber(digits.toStdString());
        return count && *count > 0.0 ? std::optional(Seconds{*count * unit.seconds}) : std::nullopt;
    }
    return std::nullopt;
}

Result<void> readRecordingLimit(const QCommandLineParser& parser, MissionOptions& options) {
    if (!parser.isSet("record-limit"))
        return {};
    const auto limit_mb = readNumber(parser.value("record-limit").toStdString());
    if (!limit_mb || !(*limit_mb >= 10.0 && *limit_mb <= 1e9))
        return failure("the limit of the recording is no number of megabytes from 10 up",
                       asWritten(parser, "record-limit"), "For example --record-limit 500");
    if (!parser.isSet("record"))
        return failure("a limit needs a recording", asWritten(parser, "record-limit"),
                       "Name its file, too: --record FILE");
    options.recording_limit_bytes = static_cast<std::uint64_t>(*limit_mb * 1e6);
    return {};
}

/// The options on what becomes of the map, and which files are left.
Result<void> readFiles(const QCommandLineParser& parser, MissionOptions& options) {
    if (const QString text = parser.value("adjust"); parser.isSet("adjust")) {
        if (text != "on" && text != "off")
            return failure("whether to adjust the map is neither on nor off", asWritten(parser, "adjust"),
                           "For example --adjust off");
        options.adjust = text == "on";
    }
    if (const QString text = parser.value("files"); parser.isSet("files")) {
        if (text != "always" && text != "failed" && text != "never")
            return failure("files are left always, failed or never", asWritten(parser, "files"),
                           "For example --files failed");
        options.files = text == "never"    ? ResultFiles::Never
                        : text == "failed" ? ResultFiles::IfFailed
                                           : ResultFiles::Always;
    }
    if (parser.isSet("export")) {
        auto formats = readFormatList(parser.value("export"), "--export");
        if (!formats)
            return tl::unexpected(formats.error());
        options.formats = *std::move(formats);
        if (options.files == ResultFiles::Never)
            return failure("no files are wanted, but some to export", asWritten(parser, "export"),
                           "Leave out --files never, or --export");
    }
    return {};
}

/// The options whose values can be wrong.
Result<void> readValues(const QCommandLineParser& parser, MissionOptions& options) {
    if (parser.isSet("seed")) {
        const auto seed = readInteger(parser.value("seed").toStdString());
        if (!seed || *seed < 0)
            return failure("the seed is not a whole number from 0 up", asWritten(parser, "seed"),
                           "For example --seed 7");
        options.seed = static_cast<std::uint64_t>(*seed);
        options.seed_chosen = true;
    }
    if (const QString text = parser.value("speed"); parser.isSet("speed") && text != "max") {
        const auto speed = readNumber(text.toStdString());
        if (!speed || !(*speed > 0.0))
            return failure("the speed is neither a number above 0 nor max", asWritten(parser, "speed"),
                           "For example --speed 10");
        options.speed_x = speed;
    }
    if (parser.isSet("battery")) {
        options.battery_life_s = readNumber(parser.value("battery").toStdString());
        if (!options.battery_life_s || !(*options.battery_life_s >= 1.0))
            return failure("the life of the battery is no number of seconds from 1 up", asWritten(parser, "battery"),
                           "For example --battery 1200");
    }
    if (parser.isSet("limit")) {
        options.limit = readTime(parser.value("limit"));
        if (!options.limit)
            return failure("the limit is no time above 0", asWritten(parser, "limit"),
                           "A number with s, min or h, for example --limit 20h");
    }
    if (auto limited = readRecordingLimit(parser, options); !limited)
        return limited;
    if (auto files = readFiles(parser, options); !files)
        return files;
    if (parser.isSet("connect")) {
        auto server = readServerAddress(parser.value("connect"));
        if (!server)
            return tl::unexpected(server.error());
        options.server = *std::move(server);
    }
    return {};
}

} // namespace

Result<ServerAddress> readServerAddress(const QString& text) {
    ServerAddress address{text};
    if (text.count(':') > 1 && !text.startsWith('['))
        return failure("an IPv6 address needs brackets", text.toStdString(), "For example --connect [fd00::7]:3000");
    const qsizetype colon = text.lastIndexOf(':');
    const bool has_port = colon >= 0 && !text.endsWith(']') && (text.count(':') == 1 || text.at(colon - 1) == ']');
    if (has_port) {
        const auto port = readInteger(text.mid(colon + 1).toStdString());
        if (!port || *port < 1 || *port > 65535)
            return failure("the port is not a whole number from 1 to 65535", text.toStdString(),
                           "For example --connect 10.0.0.5:3000");
        address = {text.left(colon), static_cast<quint16>(*port)};
    }
    if (address.host.startsWith('[') && address.host.endsWith(']'))
        address.host = address.host.mid(1, address.host.size() - 2);
    if (address.host.trimmed().isEmpty())
        return failure("the host is missing", text.toStdString(), "For example --connect 10.0.0.5:3000");
    return address;
}

Result<MissionOptions> readMissionOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    const auto parsed = parseArguments(parser, runOptions(), arguments, "Ask usar-mission run --help how to write it");
    if (!parsed)
        return tl::unexpected(parsed.error());
    MissionOptions options;
    options.behavior = parser.value("behavior");
    options.plan = parser.value("plan");
    options.result_folder = parser.value("out");
    options.recording = parser.value("record");
    options.continued = parser.value("continue");
    options.faults = parser.values("fault");
    options.values = parser.values("set");
    options.plugin_folders = parser.values("plugins");
    options.isolate = parser.isSet("isolate");
    options.course = parser.isSet("course");
    options.one_thread = parser.isSet("one-thread");
    if (const auto read = readValues(parser, options); !read)
        return tl::unexpected(read.error());
    const QStringList words = parser.positionalArguments();
    if (!options.continued.isEmpty() && words == QStringList{"run"})
        return options;
    if (!options.continued.isEmpty())
        return failure("a run that continues another takes its mission from the recording",
                       words.join(' ').toStdString(),
                       "Write usar-mission run --continue RECORDING, without a mission file");
    if (words.size() != 2 || words.first() != "run")
        return failure("this is not how to call it", words.join(' ').toStdString(),
                       "Write usar-mission run MISSION.json; --help tells more");
    options.mission_file = words.last();
    return options;
}

Result<void> applyTo(Mission& mission, const MissionOptions& options) {
    for (const QString& value : options.values)
        if (auto set = setValue(mission, value); !set)
            return set;
    if (!options.behavior.isEmpty()) {
        mission.behavior = options.behavior.toStdString();
        mission.places.erase("behavior"); // errors must not name the file
    }
    if (!options.plan.isEmpty()) {
        mission.plan = QFileInfo(options.plan).absoluteFilePath().toStdString();
        mission.places.erase("plan");
    }
    mission.isolate = mission.isolate || options.isolate;
    mission.adjust = options.adjust.value_or(mission.adjust);
    return {};
}

Seconds limitOf(const MissionOptions& options, const Mission& mission) {
    return options.limit.value_or(limitFrom(mission.limit_h));
}

Result<void> checkFaultsArePossible(const MissionOptions& options, const Mission& mission) {
    if (!options.server || (options.faults.isEmpty() && mission.faults.empty()))
        return {};
    return failure("faults are possible only in the embedded simulator", options.server->host.toStdString(),
                   "Leave out --connect, or the faults");
}

usage::Verb runVerb() {
    return {.name = "run",
            .calls = {"usar-mission run MISSION.json [options]", "usar-mission run --continue RECORDING [options]"},
            .purpose = "Flies one mission without a window and writes its results.",
            .options = runOptions(),
            .notes = {"A progress bar goes to standard error; the last line of standard output is one JSON object. "
                      "Ctrl+C keeps what was scanned."},
            .exit_codes = {{0, "done"}, {1, "the mission failed"}, {2, "bad use or input"}}};
}

} // namespace usar::mission
