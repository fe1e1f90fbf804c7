#include "app/cli/check_plan_verb.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include <QFile>

#include "app/cli/verb_complaint.h"
#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/files/plan_file.h"
#include "core/mission/reports/plan_report.h"
#include "core/mission/session/mission_runner.h"
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

struct Request {
    std::optional<QString> robot;
    QStringList files;
};

Result<Request> readRequest(const QStringList& words) {
    Request request;
    bool understood = true;
    for (qsizetype i = 1; i < words.size(); ++i) {
        const QString& word = words.at(i);
        if (word == "--robot" && i + 1 < words.size())
            request.robot = words.at(++i);
        else if (word.startsWith("--robot="))
            request.robot = word.section('=', 1);
        else if (word == "-" || !word.startsWith('-'))
            request.files += word;
        else
            understood = false;
    }
    if (!understood || request.files.isEmpty())
        return failure(
            "this is not how to call it", words.join(' ').toStdString(),
            "Write usar-mission check-plan FILE…, or - for standard input; --robot AirRobot before it checks "
            "the plans against that robot");
    return request;
}

} // namespace

int runCheckPlanVerb(const QStringList& arguments) {
    const auto request = readRequest(arguments);
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
