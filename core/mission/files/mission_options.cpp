#include "core/mission/files/mission_options.h"

#include "core/base/numbers.h"
#include "core/mission/files/replay_options.h"

namespace usar::mission {

namespace {

/// Puts the value of one option into `options`; fails on an unknown option or a bad value.
Result<void> takeOption(const QString& name, const QString& value, MissionOptions& options) {
    const std::string where = name.toStdString() + " " + value.toStdString();
    if (name == "--behavior") {
        options.behavior = value;
    } else if (name == "--plan") {
        options.plan = value;
    } else if (name == "--out") {
        options.result_folder = value;
    } else if (name == "--record") {
        options.recording = value;
    } else if (name == "--fault") {
        options.faults << value;
    } else if (name == "--plugins") {
        options.plugin_folders << value;
    } else if (name == "--seed") {
        const auto seed = readInteger(value.toStdString());
        if (!seed || *seed < 0)
            return failure("the seed is not a whole number from 0 up", where, "For example --seed 7");
        options.seed = static_cast<std::uint64_t>(*seed);
    } else if (name == "--speed") {
        const auto speed = readNumber(value.toStdString());
        if (value != "max" && !(speed && *speed > 0.0))
            return failure("the speed is neither a number above 0 nor max", where, "For example --speed 10");
        options.speed_x = value == "max" ? std::nullopt : speed;
    } else if (name == "--connect") {
        auto server = readServerAddress(value);
        if (!server)
            return tl::unexpected(server.error());
        options.server = *std::move(server);
    } else {
        return failure("there is no such option", name.toStdString(), "Ask usar-mission --help for them");
    }
    return {};
}

} // namespace

Result<ServerAddress> readServerAddress(const QString& text) {
    ServerAddress address{text};
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
    MissionOptions options;
    QStringList words;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        const QString& argument = arguments.at(i);
        if (argument == "--help" || argument == "-h") {
            options.help = true;
            return options;
        }
        if (argument == "--isolate") {
            options.isolate = true;
            continue;
        }
        if (!argument.startsWith("--")) {
            words.append(argument);
            continue;
        }
        const bool joined = argument.contains('=');
        if (!joined && i + 1 == arguments.size())
            return failure("the value is missing", argument.toStdString(), "Ask usar-mission --help how to write it");
        const QString value = joined ? argument.section('=', 1) : arguments.at(++i);
        if (auto taken = takeOption(argument.section('=', 0, 0), value, options); !taken)
            return tl::unexpected(taken.error());
    }
    if (words.size() != 2 || words.first() != "run")
        return failure("this is not how to call it", words.join(' ').toStdString(),
                       "Write usar-mission run MISSION.json; --help tells more");
    options.mission_file = words.last();
    return options;
}

QString missionHelp() {
    return QStringLiteral(
               "usar-mission run MISSION.json [options]\n"
               "\n"
               "Flies one mission without a window and writes its results.\n"
               "\n"
               "  --behavior ID        another behavior than the file's, for example airrobot/cpp\n"
               "  --plan FILE          a POSH plan of your own for a behavior that a plan decides, such as "
               "airrobot/posh\n"
               "  --seed N             noise and drift of the embedded simulator (1)\n"
               "  --speed N|max        simulated seconds per second (max)\n"
               "  --connect HOST:PORT  a USARSim server instead of the embedded simulator\n"
               "  --out DIR            where the results go (USAR_Scan on the Desktop)\n"
               "  --record FILE        every byte in and out, for replay (a new file, usually NAME.usarrec)\n"
               "  --fault TEXT         something that goes wrong in the embedded simulator, for example\n"
               "                       'wind speed=4 gust=1 from=60'; again for more. usar-sim --help lists them\n"
               "  --plugins FOLDER     robot plugins, besides those that come with the program; again for more\n"
               "  --isolate            the behavior runs in a process of its own, and may die there alone\n"
               "\n"
               "A progress bar goes to standard error; the last line of standard output is one JSON object.\n"
               "Exit code 0: done; 1: the mission failed; 2: bad use or input. Ctrl+C keeps what was scanned.\n") +
           replayHelp() +
           QStringLiteral(
               "\n"
               "usar-mission lines FILE\n"
               "\n"
               "One JSON object for each protocol line of the file, or of standard input where FILE is -.\n"
               "Exit code 0: every line was clean; 1: some had a diagnostic; 2: the file cannot be read.\n"
               "\n"
               "usar-mission check-plan [--robot NAME] FILE...\n"
               "\n"
               "One JSON object for each error and warning of the POSH plans, or of standard input where\n"
               "FILE is -: code, severity, line, column, message, file. With the name of a robot (AirRobot)\n"
               "also for what does not fit its senses and acts.\n"
               "Exit code 0: no errors; 1: some plan has an error; 2: a file cannot be read.\n"
               "\n"
               "usar-mission plan-report [--json] FILE...\n"
               "\n"
               "What the runs of POSH plans in recordings and traces came to, plan by plan: what never\n"
               "happened, what never was otherwise, what could not settle, and where the time went.\n"
               "Exit code 0: all files were read; 2: one cannot be read.\n");
}

} // namespace usar::mission
