#include "core/mission/files/report_options.h"

#include "core/mission/files/command_line.h"

namespace usar::mission {

namespace {

tl::unexpected<Error> notHowToCallIt(const QStringList& arguments, const std::string& usage) {
    return failure("this is not how to call it", arguments.join(' ').toStdString(), usage);
}

QList<QCommandLineOption> checkPlanOptions() {
    return {{"robot", "check also against the senses and acts of this robot, such as AirRobot", "NAME"},
            usage::helpOption()};
}

QList<QCommandLineOption> planReportOptions() {
    return {{"json", "JSON lines instead of text"}, usage::helpOption()};
}

} // namespace

Result<CheckPlanOptions> readCheckPlanOptions(const QStringList& arguments) {
    const std::string how =
        "Write usar-mission check-plan FILE…, or - for standard input; --robot AirRobot before it checks "
        "the plans against that robot";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, checkPlanOptions(), arguments.mid(1), how); !parsed)
        return tl::unexpected(parsed.error());
    CheckPlanOptions options;
    if (parser.isSet("robot"))
        options.robot = parser.value("robot");
    options.files = parser.positionalArguments();
    if (options.files.isEmpty())
        return notHowToCallIt(arguments, how);
    return options;
}

Result<PlanReportOptions> readPlanReportOptions(const QStringList& arguments) {
    const std::string how = "Write usar-mission plan-report [--json] FILE…, with recordings or traces";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, planReportOptions(), arguments.mid(1), how); !parsed)
        return tl::unexpected(parsed.error());
    const PlanReportOptions options{parser.isSet("json"), parser.positionalArguments()};
    if (options.files.isEmpty() || options.files.contains("-")) // a recording is read in any order
        return notHowToCallIt(arguments, how);
    return options;
}

Result<QString> readLinesFile(const QStringList& arguments) {
    const std::string how = "Write usar-mission lines FILE, or - for standard input";
    QCommandLineParser parser;
    if (const auto parsed = parseArguments(parser, {usage::helpOption()}, arguments.mid(1), how); !parsed)
        return tl::unexpected(parsed.error());
    if (parser.positionalArguments().size() != 1)
        return notHowToCallIt(arguments, how);
    return parser.positionalArguments().first();
}

QList<usage::Verb> reportVerbs() {
    return {{.name = "lines",
             .calls = {"usar-mission lines FILE"},
             .purpose = "Prints one JSON object for each protocol line of the file.",
             .options = {usage::helpOption()},
             .notes = {"- is standard input."},
             .exit_codes = {{0, "every line was clean"},
                            {1, "some line had a diagnostic"},
                            {2, "the file cannot be read, or bad use"}}},
            {.name = "check-plan",
             .calls = {"usar-mission check-plan [--robot NAME] PLAN.lap..."},
             .purpose = "Prints one JSON object for each error and warning of the POSH plans: code, severity, line, "
                        "column, message, file.",
             .options = checkPlanOptions(),
             .notes = {"- is standard input."},
             .exit_codes = {{0, "no errors"}, {1, "some plan has an error"}, {2, "a file cannot be read, or bad use"}}},
            {.name = "plan-report",
             .calls = {"usar-mission plan-report [--json] FILE..."},
             .purpose = "Tells, plan by plan, what the runs of POSH plans in recordings and traces came to: what never "
                        "happened, what never was otherwise, what could not settle, and where the time went.",
             .options = planReportOptions(),
             .exit_codes = {{0, "all files were read"}, {2, "one cannot be read, or bad use"}}}};
}

} // namespace usar::mission
