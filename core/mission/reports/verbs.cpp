#include "core/mission/reports/verbs.h"

#include <algorithm>
#include <map>

#include <QFile>

#include "core/agent/plugins/plugin_loader.h"
#include "core/link/recording_text.h"
#include "core/mission/files/plan_file.h"
#include "core/mission/files/report_options.h"
#include "core/mission/reports/line_report.h"
#include "core/mission/reports/plan_report.h"
#include "core/mission/reports/recorded_runs.h"
#include "core/mission/reports/run_report_text.h"
#include "core/mission/runs/mission_runner.h"
#include "core/mission/runs/recording_mcap.h"

namespace usar::mission {

namespace {

int complain(const VerbStreams& streams, const Error& error) {
    streams.complain(error.text());
    return BadInput;
}

void warn(const VerbStreams& streams, const QString& file, const std::string& complaint) {
    if (!complaint.empty())
        streams.complain(file.toStdString() + ": " + complaint);
}

/// Calls `read` with the file of this name, or with the input for "-". Returns its exit code, or that of a file that
/// cannot be opened.
template <class Read>
int withInput(const QString& name, const VerbStreams& streams, Read read) {
    if (name == "-")
        return read(streams.input);
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return complain(streams, {file.errorString().toStdString(), name.toStdString(), "Check the name"});
    return read(file);
}

int runLines(const QStringList& arguments, const QStringList&, const VerbStreams& streams) {
    const auto file = readLinesFile(arguments);
    if (!file)
        return complain(streams, file.error());
    return withInput(*file, streams, [&](QIODevice& input) {
        const auto counts = reportLines(input, streams.output);
        return counts ? static_cast<int>(counts->with_diagnostics > 0) : complain(streams, counts.error());
    });
}

int runCheckPlan(const QStringList& arguments, const QStringList& plugin_folders, const VerbStreams& streams) {
    const auto options = readCheckPlanOptions(arguments);
    if (!options)
        return complain(streams, options.error());
    agent::PluginLoader plugins;
    const agent::RobotDescription* robot = nullptr;
    if (options->robot) {
        plugins.scan(plugin_folders);
        const auto found = robotForPlans(plugins.robots(), *options->robot);
        if (!found)
            return complain(streams, found.error());
        robot = *found;
    }
    int worst = Done;
    for (const QString& name : options->files)
        worst = std::max(worst, withInput(name, streams, [&](QIODevice& input) {
                             const auto sound =
                                 reportPlan(input, name, streams.output, robot ? &robot->primitives : nullptr);
                             return sound ? static_cast<int>(!*sound) : complain(streams, sound.error());
                         }));
    return worst;
}

int addRunsOf(const QString& file, std::vector<PlanRuns>& plans, const VerbStreams& streams) {
    const auto recorded = readTraces(file);
    if (!recorded)
        return complain(streams, recorded.error());
    warn(streams, file, recorded->complaint);
    for (const std::string& trace : recorded->traces)
        warn(streams, file, addRuns(trace, plans));
    return Done;
}

int runPlanReport(const QStringList& arguments, const QStringList&, const VerbStreams& streams) {
    const auto options = readPlanReportOptions(arguments);
    if (!options)
        return complain(streams, options.error());
    std::vector<PlanRuns> plans;
    int worst = Done;
    for (const QString& file : options->files)
        worst = std::max(worst, addRunsOf(file, plans, streams));
    for (const PlanRuns& plan : plans) {
        const QByteArray report = options->json ? runReportJson(plan.statistics, plan.runs)
                                                : QByteArray::fromStdString(runReportText(plan.statistics, plan.runs));
        if (streams.output.write(report) != report.size())
            return complain(streams,
                            {"the output cannot be written", "standard output", "Make room, or write elsewhere"});
    }
    return worst;
}

using Verb = int (*)(const QStringList& arguments, const QStringList& plugin_folders, const VerbStreams& streams);
const std::map<QString, Verb> verbs{{"lines", runLines}, {"check-plan", runCheckPlan}, {"plan-report", runPlanReport}};

Result<void> openOutput(const QString& name, QFile& file) {
    if (file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return {};
    if (QFile::exists(name))
        return failure("there is a file of this name already, and it is left alone", name.toStdString(),
                       "Give the output another name");
    return failure(file.errorString().toStdString(), name.toStdString(), "Give the output another place");
}

Result<void> convert(const ReplayOptions& options, QIODevice& input, QIODevice& output) {
    // A recording is not read in order, so it must be a file.
    if (options.verb == ReplayVerb::ToText)
        return link::recordingToText(options.file == "-" ? QString("/dev/stdin") : options.file, output);
    return link::textToRecording(input, options.file, output);
}

} // namespace

bool isReportVerb(const QString& word) {
    return verbs.contains(word);
}

int runReportVerb(const QStringList& arguments, const QStringList& plugin_folders, const VerbStreams& streams) {
    return verbs.at(arguments.value(0))(arguments, plugin_folders, streams);
}

int convertRecording(const ReplayOptions& options, const VerbStreams& streams) {
    return withInput(options.file, streams, [&](QIODevice& input) {
        QFile file(options.output);
        const bool to_file = options.output != "-";
        if (const auto ready = to_file ? openOutput(options.output, file) : Result<void>(); !ready)
            return complain(streams, ready.error());
        const auto done = convert(options, input, to_file ? static_cast<QIODevice&>(file) : streams.output);
        if (done)
            return static_cast<int>(Done);
        if (to_file) {
            file.close();
            file.remove();
        }
        return complain(streams, done.error());
    });
}

int exportRecording(const ReplayOptions& options, const VerbStreams& streams) {
    const auto summary = options.output == "-" ? recordingToMcap(options.file, streams.output)
                                               : recordingToMcapFile(options.file, options.output, false);
    if (!summary)
        return complain(streams, summary.error());
    warn(streams, options.file, summary->complaint);
    return summary->damaged ? MissionFailed : Done;
}

} // namespace usar::mission
