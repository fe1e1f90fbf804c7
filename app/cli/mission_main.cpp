// usar-mission: flies one mission without a window; its other verbs fly none, but read files and recordings.
#include <cstdio>
#include <optional>

#include <QFile>
#include <QGuiApplication>

#include "app/cli/campaign_verb.h"
#include "app/cli/compare_verb.h"
#include "app/cli/console.h"
#include "app/cli/mission_flight.h"
#include "app/cli/mission_program.h"
#include "app/cli/run_worker.h"
#include "app/cli/server_files_verb.h"
#include "core/base/version.h"
#include "core/campaign/runs/run_request.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/reports/export_verb.h"
#include "core/mission/reports/replay_verb.h"
#include "core/mission/runs/mission_runner.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/quiet_qt.h"
#include "core/server/embedded/quit_signals.h"
#include "core/usage/help_text.h"

namespace {

using namespace usar;
using app::complain;

/// Runs the verb that `arguments` begin with and returns the program's exit code; nullopt if it is none of these verbs.
/// Errors go to standard error.
std::optional<int> runVerb(const QStringList& arguments) {
    const bool reports = mission::isReportVerb(arguments.value(0));
    const bool exports = mission::isExportVerb(arguments.value(0));
    if (!reports && !exports && !mission::isReplayVerb(arguments.value(0)))
        return std::nullopt;
    QFile input, output;
    if (!input.open(stdin, QIODevice::ReadOnly) || !output.open(stdout, QIODevice::WriteOnly)) {
        complain("standard input or output cannot be opened");
        return mission::BadInput;
    }
    const mission::VerbStreams streams{input, output, complain};
    std::optional<server::QuitSignals> signals_; // Only a replay is interrupted; the other verbs just end.
    const auto prepare = [&](mission::ReplayRunner& runner) {
        QObject::connect(&signals_.emplace(), &server::QuitSignals::quit, &runner, &mission::ReplayRunner::interrupt);
    };
    const int exit_code = reports   ? mission::runReportVerb(arguments, server::pluginFolders(), streams)
                          : exports ? mission::runExportVerb(arguments, streams)
                                    : mission::runReplayVerb(arguments, streams, prepare);
    if (output.flush())
        return exit_code;
    complain(Error{"the output takes no more", "standard output", "Make room, or write elsewhere"}.text());
    return mission::BadInput;
}

} // namespace

int main(int argc, char** argv) {
    usar::server::keepQtQuiet();
    if (usar::answersVersion(argc, argv))
        return 0;
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // pictures contain text, which needs a QGuiApplication
    QGuiApplication application(argc, argv);
    QCoreApplication::setApplicationName("usar-mission");
    if (const auto help = usage::answerToHelp(app::missionProgram(), QCoreApplication::arguments().mid(1))) {
        std::printf("%s", qPrintable(*help));
        return 0;
    }
    if (const auto exit_code = runVerb(QCoreApplication::arguments().mid(1)))
        return *exit_code;
    const QString verb = QCoreApplication::arguments().value(1);
    if (verb == "campaign")
        return app::runCampaignVerb(QCoreApplication::arguments().mid(1));
    if (verb == "compare")
        return app::runCompareVerb(QCoreApplication::arguments().mid(1));
    if (verb == "server-files")
        return app::runServerFilesVerb(QCoreApplication::arguments().mid(1));
    app::Preloaded loaded;
    if (verb == campaign::worker_verb)
        return app::runWorker(loaded);
    return app::flyMission(QCoreApplication::arguments().mid(1), loaded);
}
