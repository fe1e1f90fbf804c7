#include "app/check_plan_verb.h"

#include <algorithm>
#include <cstdio>

#include <QFile>

#include "core/mission/mission_runner.h"
#include "core/mission/plan_report.h"

namespace usar::app {

namespace {

int complain(const Error& error) {
    std::fprintf(stderr, "usar-mission: %s\n", error.text().c_str());
    return mission::BadInput;
}

int checkOne(const QString& name, QIODevice& output) {
    QFile input(name);
    const bool opened = name == "-" ? input.open(stdin, QIODevice::ReadOnly) : input.open(QIODevice::ReadOnly);
    if (!opened)
        return complain({input.errorString().toStdString(), name.toStdString(), "Check the name"});
    const auto sound = mission::reportPlan(input, name, output);
    if (!sound)
        return complain(sound.error());
    return *sound ? 0 : 1;
}

} // namespace

int runCheckPlanVerb(const QStringList& arguments) {
    const QStringList files = arguments.mid(1);
    const bool has_option = std::any_of(files.begin(), files.end(),
                                        [](const QString& word) { return word.startsWith('-') && word != "-"; });
    if (files.isEmpty() || has_option)
        return complain({"this is not how to call it", arguments.join(' ').toStdString(),
                         "Write usar-mission check-plan FILE…, or - for standard input"});
    QFile output;
    if (!output.open(stdout, QIODevice::WriteOnly))
        return complain({output.errorString().toStdString(), "standard output", "Give it somewhere to go"});
    int worst = 0;
    for (const QString& file : files)
        worst = std::max(worst, checkOne(file, output));
    return worst;
}

} // namespace usar::app
