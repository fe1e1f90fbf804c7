#include "core/campaign/comparison/compare_options.h"

#include "core/mission/files/command_line.h"

namespace usar::campaign {

Result<CompareOptions> readCompareOptions(const QStringList& arguments) {
    const std::string usage = "Write usar-mission compare DIR [DIR_B]; --help tells more";
    QCommandLineParser parser;
    const auto parsed = mission::parseArguments(parser,
                                                {{"baseline", {}, "VARIANT"},
                                                 {"candidate", {}, "VARIANT"},
                                                 {"html", {}, "FILE"},
                                                 {"junit", {}, "FILE"},
                                                 QCommandLineOption("json"),
                                                 QCommandLineOption(QStringList{"h", "help"})},
                                                arguments.mid(1), usage);
    CompareOptions options;
    options.help = parser.isSet("help");
    if (options.help)
        return options;
    if (!parsed)
        return tl::unexpected(parsed.error());
    options.folders = parser.positionalArguments();
    options.baseline = parser.value("baseline");
    options.candidate = parser.value("candidate");
    options.html = parser.value("html");
    options.junit = parser.value("junit");
    options.json = parser.isSet("json");
    if (options.folders.isEmpty() || options.folders.size() > 2)
        return failure("this is not how to call it", arguments.join(' ').toStdString(), usage);
    return options;
}

QString compareHelp() {
    return QStringLiteral(
        "usar-mission compare DIR [DIR_B] [options]\n"
        "\n"
        "Says which of two variants of a campaign is better, pair by pair, and how sure that is. With two\n"
        "folders, a variant of the first is compared with one of the second; they need the same missions and\n"
        "seeds.\n"
        "\n"
        "  --baseline VARIANT   what is compared with (the first variant)\n"
        "  --candidate VARIANT  what is compared (the second variant, or the first of DIR_B)\n"
        "  --html FILE          a page with plots, the worst runs and the failures by reason\n"
        "  --junit FILE         every run as a test case, for continuous integration\n"
        "  --json               JSON instead of the table\n"
        "\n"
        "Exit code 0: the candidate is not worse; 1: it is worse; 2: bad use or input; 3: undecided.\n");
}

} // namespace usar::campaign
