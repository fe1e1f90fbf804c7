#include "app/cli/check_plan_verb.h"

#include <algorithm>
#include <cstdio>

#include <QFile>

#include "app/cli/verb_complaint.h"
#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/plan_file.h"
#include "core/mission/files/report_options.h"
#include "core/mission/reports/plan_report.h"
#include "core/mission/runs/mission_runner.h"
#include "core/server/embedded/program_files.h"

namespace usar::app {

namespace {

int checkOne(const QString& name, const agent::RobotDescription* robot, QIODevice& output) {
    QFile input(name);
    const bool opened = name == "-" ? input.open(stdin, QIODevice::ReadOnly) : input.open(QIODevice::ReadOnly);
    if (!opened)
        return complain({input.errorString().toStdString(), name.toStdString(), "Check the name"});
    const auto sound = mission::reportPlan(input, name, output, robot ? &robot->primitives : nullptr);
    if (!sound)
        return complain(sound.error());
    return *sound ? 0 : 1;
}

} // namespace

int runCheckPlanVerb(const QStringList& arguments) {
    const auto request = mission::readCheckPlanOptions(arguments);
    if (!request)
        return complain(request.error());
    agent::PluginLoader plugins;
    const agent::RobotDescription* robot = nullptr;
    if (request->robot) {
        plugins.scan(server::pluginFolders());
        const auto found = mission::robotForPlans(plugins.robots(), *request->robot);
        if (!found)
            return complain(found.error());
        robot = *found;
    }
    QFile output;
    if (!output.open(stdout, QIODevice::WriteOnly))
        return complain({output.errorString().toStdString(), "standard output", "Give it somewhere to go"});
    int worst = 0;
    for (const QString& file : request->files)
        worst = std::max(worst, checkOne(file, robot, output));
    return worst;
}

} // namespace usar::app
