#include "core/mission/files/replay_options.h"

#include <array>
#include <utility>

#include "core/base/numbers.h"
#include "core/link/replay.h"

namespace usar::mission {

namespace {

const std::array<std::pair<QString, ReplayVerb>, 3> verbs{{{"replay", ReplayVerb::Replay},
                                                           {"recording-to-text", ReplayVerb::ToText},
                                                           {"text-to-recording", ReplayVerb::ToRecording}}};

Result<Seconds> readMoment(const QString& value, const std::string& where) {
    const auto seconds = readNumber(value.toStdString());
    if (!seconds || !(*seconds >= 0.0))
        return failure("the moment is not a number of seconds from 0 up", where,
                       "Seconds count from the beginning of the recording, for example --from 90");
    return Seconds{*seconds};
}

Result<void> takeReplayOption(const QString& name, const QString& value, ReplayOptions& options) {
    const std::string where = name.toStdString() + " " + value.toStdString();
    if (name == "--speed") {
        const auto speed = readNumber(value.toStdString());
        if (value != "max" && !(speed && *speed >= link::Replayer::slowest && *speed <= link::Replayer::fastest))
            return failure("the speed is neither a number from 0.1 to 100 nor max", where, "For example --speed 10");
        options.speed = value == "max" ? std::numeric_limits<double>::infinity() : *speed;
        return {};
    }
    if (name != "--from" && name != "--to")
        return failure("there is no such option", name.toStdString(), "Ask usar-mission --help for them");
    const auto moment = readMoment(value, where);
    if (!moment)
        return tl::unexpected(moment.error());
    if (name == "--from")
        options.from = *moment;
    else
        options.to = *moment;
    return {};
}

} // namespace

bool isReplayVerb(const QString& word) {
    for (const auto& [known, verb] : verbs)
        if (known == word)
            return true;
    return false;
}

Result<ReplayOptions> readReplayOptions(const QStringList& arguments) {
    ReplayOptions options;
    for (const auto& [known, verb] : verbs)
        if (known == arguments.value(0))
            options.verb = verb;
    QStringList words;
    for (qsizetype i = 1; i < arguments.size(); ++i) {
        const QString& argument = arguments.at(i);
        if (argument == "--help" || argument == "-h") {
            options.help = true;
            return options;
        }
        if (!argument.startsWith("--") || options.verb != ReplayVerb::Replay) {
            words.append(argument);
            continue;
        }
        const bool joined = argument.contains('=');
        if (!joined && i + 1 == arguments.size())
            return failure("the value is missing", argument.toStdString(), "Ask usar-mission --help how to write it");
        const QString value = joined ? argument.section('=', 1) : arguments.at(++i);
        if (auto taken = takeReplayOption(argument.section('=', 0, 0), value, options); !taken)
            return tl::unexpected(taken.error());
    }
    const bool converts = options.verb != ReplayVerb::Replay;
    if (words.size() != (converts ? 2 : 1))
        return failure("this is not how to call it", arguments.join(' ').toStdString(),
                       "Write usar-mission " + arguments.value(0).toStdString() + (converts ? " FROM TO" : " FILE") +
                           "; --help tells more");
    if (options.to && *options.to < options.from)
        return failure("it ends before it begins", "--to " + fixed(options.to->count(), 1),
                       "Give a moment after --from");
    options.file = words.first();
    options.output = words.value(1);
    return options;
}

QString replayHelp() {
    return QStringLiteral(
        "\n"
        "usar-mission replay FILE [options]\n"
        "\n"
        "Plays a recording through the reader and tells what is in it.\n"
        "\n"
        "  --speed N|max        times the pace of the recording, 0.1 to 100 (max)\n"
        "  --from S, --to S     only this part, in seconds since the recording began\n"
        "\n"
        "A recording lasts as long as it took, or as long as its robot's clock says, whichever is more.\n"
        "\n"
        "The last line of standard output is one JSON object. Exit code 0: done; 1: part of the file is damaged\n"
        "or incomplete, and the rest was played; 2: bad use or input.\n"
        "\n"
        "usar-mission recording-to-text FILE TEXT\n"
        "usar-mission text-to-recording TEXT FILE\n"
        "\n"
        "Without loss both ways; - is standard input or output. Nothing is written over a file that exists.\n");
}

} // namespace usar::mission
