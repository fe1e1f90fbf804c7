#include "core/mission/files/report_options.h"

#include "core/mission/files/command_line.h"

namespace usar::mission {

namespace {

tl::unexpected<Error> notHowToCallIt(const QStringList& arguments, const std::string& usage) {
    return failure("this is not how to call it", arguments.join(' ').toStdString(), usage);
}

} // namespace

Result<CheckPlanOptions> readCheckPlanOptions(const QStringList& arguments) {
    const std::string usage =
        "Write usar-mission check-plan FILE…, or - for standard input; --robot AirRobot before it checks "
        "the plans against that robot";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, {QCommandLineOption("robot", {}, "NAME")}, arguments.mid(1), usage);
        !parsed)
        return tl::unexpected(parsed.error());
    CheckPlanOptions options;
    if (parser.isSet("robot"))
        options.robot = parser.value("robot");
    options.files = parser.positionalArguments();
    if (options.files.isEmpty())
        return notHowToCallIt(arguments, usage);
    return options;
}

Result<PlanReportOptions> readPlanReportOptions(const QStringList& arguments) {
    const std::string usage = "Write usar-mission plan-report [--json] FILE…, with recordings or traces";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, {QCommandLineOption("json")}, arguments.mid(1), usage); !parsed)
        return tl::unexpected(parsed.error());
    const PlanReportOptions options{parser.isSet("json"), parser.positionalArguments()};
    if (options.files.isEmpty() || options.files.contains("-")) // a recording is read in any order
        return notHowToCallIt(arguments, usage);
    return options;
}

Result<QString> readLinesFile(const QStringList& arguments) {
    const std::string usage = "Write usar-mission lines FILE, or - for standard input";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, {}, arguments.mid(1), usage); !parsed)
        return tl::unexpected(parsed.error());
    if (parser.positionalArguments().size() != 1)
        return notHowToCallIt(arguments, usage);
    return parser.positionalArguments().first();
}

} // namespace usar::mission
