#include "core/campaign/comparison/compare_options.h"

#include "core/mission/files/command_line.h"

namespace usar::campaign {

Result<CompareOptions> readCompareOptions(const QStringList& arguments) {
    const std::string how = "Write usar-mission compare DIR [DIR_B]; --help tells more";
    QCommandLineParser parser;
    const auto parsed = mission::parseArguments(parser, compareVerb().options, arguments.mid(1), how);
    if (!parsed)
        return tl::unexpected(parsed.error());
    CompareOptions options;
    options.folders = parser.positionalArguments();
    options.baseline = parser.value("baseline");
    options.candidate = parser.value("candidate");
    options.html = parser.value("html");
    options.junit = parser.value("junit");
    options.curve = parser.value("curve");
    options.json = parser.isSet("json");
    if (options.folders.isEmpty() || options.folders.size() > 2)
        return failure("this is not how to call it", arguments.join(' ').toStdString(), how);
    return options;
}

usage::Verb compareVerb() {
    return {
        .name = "compare",
        .calls = {"usar-mission compare DIR [DIR_B] [options]"},
        .purpose = "Says which variants of a campaign are better than its first, pair by pair, and how sure that is. "
                   "With two folders, a variant of the first is compared with those of the second; they need the "
                   "same missions and seeds.",
        .options = {{"baseline", "what is compared with (the first variant)", "VARIANT"},
                    {"candidate", "what is compared (all other variants, or those of DIR_B)", "VARIANT"},
                    {"html", "a page with plots, the worst runs and the failures by reason", "FILE"},
                    {"curve", "a picture (SVG) of time against error and coverage, with all variants", "FILE"},
                    {"junit", "every run as a test case, for continuous integration", "FILE"},
                    {"json", "JSON instead of the table"},
                    usage::helpOption()},
        .exit_codes = {{0, "no candidate is worse"}, {1, "one is worse"}, {2, "bad use or input"}, {3, "undecided"}}};
}

} // namespace usar::campaign
