#include "core/mission/files/replay_options.h"

#include <QMap>

#include "core/base/numbers.h"
#include "core/link/replay.h"
#include "core/mission/files/command_line.h"

namespace usar::mission {

namespace {

const QMap<QString, ReplayVerb> verbs{{"replay", ReplayVerb::Replay},
                                      {"recording-to-text", ReplayVerb::ToText},
                                      {"text-to-recording", ReplayVerb::ToRecording},
                                      {"recording-to-mcap", ReplayVerb::ToMcap}};

/// The moment that the option gives; nullopt without the option.
Result<std::optional<Seconds>> readMoment(const QCommandLineParser& parser, const QString& option) {
    if (!parser.isSet(option))
        return std::nullopt;
    const auto seconds = readNumber(parser.value(option).toStdString());
    if (!seconds || !(*seconds >= 0.0))
        return failure("the moment is not a number of seconds from 0 up", asWritten(parser, option),
                       "Seconds count from the beginning of the recording, for example --from 90");
    return Seconds{*seconds};
}

QList<QCommandLineOption> optionsOf(ReplayVerb verb) {
    if (verb != ReplayVerb::Replay)
        return {usage::helpOption()};
    return {{"speed", "times the pace of the recording, 0.1 to 100 (max)", "N|max"},
            {"from", "from this second on, since the recording began (0)", "S"},
            {"to", "to this second, since the recording began (its end)", "S"},
            usage::helpOption()};
}

/// The options of the verb `replay`.
Result<void> readValues(const QCommandLineParser& parser, ReplayOptions& options) {
    if (const QString text = parser.value("speed"); parser.isSet("speed") && text != "max") {
        const auto speed = readNumber(text.toStdString());
        if (!speed || !(*speed >= link::Replayer::slowest && *speed <= link::Replayer::fastest))
            return failure("the speed is neither a number from 0.1 to 100 nor max", asWritten(parser, "speed"),
                           "For example --speed 10");
        options.speed = *speed;
    }
    const auto from = readMoment(parser, "from");
    const auto to = readMoment(parser, "to");
    if (!from || !to)
        return tl::unexpected(from ? to.error() : from.error());
    options.from = from->value_or(options.from);
    options.to = *to;
    return {};
}

} // namespace

bool isReplayVerb(const QString& word) {
    return verbs.contains(word);
}

Result<ReplayOptions> readReplayOptions(const QStringList& arguments) {
    ReplayOptions options;
    options.verb = verbs.value(arguments.value(0));
    QCommandLineParser parser;
    const std::string verb = arguments.value(0).toStdString();
    const auto parsed = parseArguments(parser, optionsOf(options.verb), arguments.mid(1),
                                       "Ask usar-mission " + verb + " --help how to write it");
    if (!parsed)
        return tl::unexpected(parsed.error());
    if (options.verb == ReplayVerb::Replay)
        if (const auto read = readValues(parser, options); !read)
            return tl::unexpected(read.error());
    const QStringList words = parser.positionalArguments();
    const bool converts = options.verb != ReplayVerb::Replay;
    if (words.size() != (converts ? 2 : 1))
        return failure("this is not how to call it", arguments.join(' ').toStdString(),
                       "Write usar-mission " + verb + (converts ? " FROM TO" : " FILE") + "; --help tells more");
    if (options.to && *options.to < options.from)
        return failure("it ends before it begins", "--to " + fixed(options.to->count(), 1),
                       "Give a moment after --from");
    options.file = words.first();
    options.output = words.value(1);
    return options;
}

QList<usage::Verb> replayVerbs() {
    const QString lossless =
        "Nothing is lost either way; - is standard input or output. Nothing is written over a file that exists.";
    const QList<std::pair<int, QString>> codes{{0, "done"}, {2, "bad use or input"}};
    return {{.name = "replay",
             .calls = {"usar-mission replay RECORDING [options]"},
             .purpose = "Plays a recording through the reader and reports what is in it.",
             .options = optionsOf(ReplayVerb::Replay),
             .notes = {"A recording lasts as long as it took, or as long as its robot's clock says, whichever is more.",
                       "The last line of standard output is one JSON object."},
             .exit_codes = {{0, "done"},
                            {1, "part of the file is damaged or incomplete, and the rest was played"},
                            {2, "bad use or input"}}},
            {.name = "recording-to-text",
             .calls = {"usar-mission recording-to-text RECORDING FILE"},
             .purpose = "Writes a recording as text.",
             .options = optionsOf(ReplayVerb::ToText),
             .notes = {lossless},
             .exit_codes = codes},
            {.name = "text-to-recording",
             .calls = {"usar-mission text-to-recording FILE RECORDING"},
             .purpose = "Makes a recording of such a text.",
             .options = optionsOf(ReplayVerb::ToRecording),
             .notes = {lossless},
             .exit_codes = codes},
            {.name = "recording-to-mcap",
             .calls = {"usar-mission recording-to-mcap RECORDING FILE.mcap"},
             .purpose = "Writes a recording for Foxglove and other programs of robotics.",
             .options = optionsOf(ReplayVerb::ToMcap),
             .notes = {"Poses, scans, ranges, depth images, height map, log, plan, status and commands, in meters, "
                       "radians and the time of the protocol.",
                       "- is standard output. Nothing is written over a file that exists."},
             .exit_codes = {{0, "done"},
                            {1, "part of the recording is damaged or incomplete, and the rest was written"},
                            {2, "bad use or input"}}}};
}

} // namespace usar::mission
