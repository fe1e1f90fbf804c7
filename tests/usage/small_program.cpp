#include "tests/usage/small_program.h"

#include <QDir>
#include <QProcess>

namespace usar::usage_tests {

using namespace usage;

Program smallProgram() {
    return {.name = "try-it",
            .title = "try what tables become",
            .description = {"'Tis a first paragraph.", ".TH would begin a page; a \\ is a backslash, … an ellipsis."},
            .verbs = {{.name = "fly",
                       .calls = {"try-it fly MISSION.json [options]", "try-it fly --again RECORDING"},
                       .purpose = "Flies.",
                       .options = {{"speed", "how fast", "N|max", "1"},
                                   {"again", "fly this again", "RECORDING"},
                                   {"plan", "a plan", "PLAN.lap"},
                                   {"adjust", "whether to adjust", "on|off"},
                                   {"out",
                                    "where results go, with a sentence that is long enough to be wrapped into a "
                                    "second line of the help, and more",
                                    "DIR"},
                                   {"quiet", "say nothing"},
                                   helpOption()},
                       .notes = {"A note."},
                       .exit_codes = {{0, "flown"}, {1, "fallen"}}},
                      {.name = "tell",
                       .calls = {"try-it tell [--json] FILE..."},
                       .purpose = "Tells.",
                       .options = {{"json", "as JSON"}, helpOption()},
                       .exit_codes = {{0, "told"}}}},
            .sections = {{.title = "Files", .entries = {{"MISSION.json", "a mission"}}}},
            .see_also = {"usar-sim", "usar-mission"}};
}

Program plainProgram() {
    return {.name = "plain",
            .title = "do one thing",
            .description = {"It does one thing."},
            .verbs = {{.name = {},
                       .calls = {"plain [options] [WORLD.sdf | FOLDER]"},
                       .purpose = "Does one thing.",
                       .options = {{"kind", "which", "a|b", "a"}, helpOption(), versionOption()},
                       .exit_codes = {{0, "done"}}}},
            .sections = {{.title = "Kinds", .text = "There are:", .entries = {{"a", "the first"}}, .in_help = true},
                         {.title = "Secrets", .entries = {{"x", "not for the help"}}}}};
}

QString outputOf(const QString& program, const QStringList& arguments, const QByteArray& input, const QString& folder) {
    QProcess process;
    process.setWorkingDirectory(folder.isEmpty() ? QDir::currentPath() : folder);
    process.start(program, arguments);
    process.write(input);
    process.closeWriteChannel();
    const bool ended = process.waitForFinished(60'000) && process.exitStatus() == QProcess::NormalExit;
    QStringList complaints = QString::fromUtf8(process.readAllStandardError()).split('\n', Qt::SkipEmptyParts);
    complaints.removeIf(
        [](const QString& line) { return line.startsWith("QStandardPaths"); }); // of the machine's folders
    if (ended && process.exitCode() == 0 && complaints.isEmpty())
        return QString::fromUtf8(process.readAllStandardOutput());
    qWarning("%s %s: %s", qPrintable(program), qPrintable(arguments.join(' ')), qPrintable(complaints.join('\n')));
    return {};
}

} // namespace usar::usage_tests
