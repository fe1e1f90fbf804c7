#include "app/cli/plan_report_verb.h"

#include <algorithm>
#include <cstdio>

#include "app/cli/verb_complaint.h"
#include "core/mission/files/report_options.h"
#include "core/mission/reports/recorded_runs.h"
#include "core/mission/reports/run_report_text.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

namespace {

void warn(const QString& file, const std::string& complaint) {
    if (!complaint.empty())
        std::fprintf(stderr, "usar-mission: %s: %s\n", qPrintable(file), complaint.c_str());
}

int addFile(const QString& file, std::vector<mission::PlanRuns>& plans) {
    const auto recorded = mission::readTraces(file);
    if (!recorded)
        return complain(recorded.error());
    warn(file, recorded->complaint);
    for (const std::string& trace : recorded->traces)
        warn(file, mission::addRuns(trace, plans));
    return mission::Done;
}

} // namespace

int runPlanReportVerb(const QStringList& arguments) {
    const auto options = mission::readPlanReportOptions(arguments);
    if (!options)
        return complain(options.error());
    std::vector<mission::PlanRuns> plans;
    int worst = mission::Done;
    for (const QString& file : options->files)
        worst = std::max(worst, addFile(file, plans));
    for (const mission::PlanRuns& plan : plans) {
        const std::string report = options->json ? mission::runReportJson(plan.statistics, plan.runs).toStdString()
                                                 : mission::runReportText(plan.statistics, plan.runs);
        std::fwrite(report.data(), 1, report.size(), stdout);
    }
    if (std::fflush(stdout) != 0)
        return complain({"the output cannot be written", "standard output", "Make room, or write elsewhere"});
    return worst;
}

} // namespace usar::app
