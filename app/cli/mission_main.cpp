// usar-mission: runs one mission without a window; further verbs work on recordings, protocol lines and plans.
#include <cstdio>
#include <memory>

#include <unistd.h>

#include <QElapsedTimer>
#include <QFileInfo>
#include <QGuiApplication>
#include <QJsonDocument>

#include "app/cli/check_plan_verb.h"
#include "app/cli/lines_verb.h"
#include "app/cli/plan_report_verb.h"
#include "app/cli/replay_verbs.h"
#include "app/host/headless_simulator.h"
#include "app/host/quit_signals.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/files/replay_options.h"
#include "core/mission/session/progress_text.h"
#include "core/mission/session/run_summary.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"

namespace {

using namespace usar;

/// Progress on standard error: a bar that redraws itself on a terminal, otherwise one line per 10 %.
class ProgressBar {
public:
    ProgressBar() { wall_.start(); }

    void show(const mission::Progress& progress) {
        const Seconds wall(static_cast<double>(wall_.elapsed()) / 1000.0);
        const int tenth = static_cast<int>(progress.percent / 10.0);
        if (is_terminal_) {
            std::fprintf(stderr, "\r%s\x1b[K", mission::progressLine(progress, wall).c_str());
            drawn_ = true;
        } else if (tenth > last_tenth_) {
            std::fprintf(stderr, "%s\n", mission::progressLine(progress, wall).c_str());
            last_tenth_ = tenth;
        }
    }
    /// Prints a line of text above the bar.
    void say(const std::string& text) {
        std::fprintf(stderr, "%s%s\n", drawn_ ? "\r\x1b[K" : "", text.c_str());
        drawn_ = false;
    }

private:
    const bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
    QElapsedTimer wall_;
    int last_tenth_ = -1;
    bool drawn_ = false;
};

int end(int exit_code, const QJsonObject& summary) {
    std::printf("%s\n", QJsonDocument(summary).toJson(QJsonDocument::Compact).constData());
    return exit_code;
}

/// Ends the program with an error; `known` contains what is known about the run, which never began.
int refuse(const Error& error, mission::RunSummary known = {}) {
    std::fprintf(stderr, "usar-mission: %s\n", error.text().c_str());
    known.reason = error.text();
    return end(mission::BadInput, mission::toJson(known));
}

mission::RunSummary knownOf(const mission::MissionOptions& options) {
    mission::RunSummary known;
    known.behavior = options.behavior.toStdString();
    known.seed = options.seed;
    return known;
}

Result<std::vector<sim::Fault>> faultsOf(const mission::MissionOptions& options, const mission::Mission& plan) {
    auto faults = server::readFaults(server::textsOf(plan.faults));
    if (!faults)
        return tl::unexpected(mission::atValue(plan, "faults", faults.error()));
    auto more = server::readFaults(options.faults);
    if (!more)
        return more;
    faults->insert(faults->end(), more->begin(), more->end());
    return faults;
}

/// Applies the options of the command line, which take precedence over the mission file.
void applyTo(mission::Mission& plan, const mission::MissionOptions& options) {
    if (!options.behavior.isEmpty()) {
        plan.behavior = options.behavior.toStdString();
        plan.places.erase("behavior"); // An error would not be in the file.
    }
    if (!options.plan.isEmpty()) {
        plan.plan = QFileInfo(options.plan).absoluteFilePath().toStdString();
        plan.places.erase("plan");
    }
    plan.isolate = plan.isolate || options.isolate;
}

/// Starts an embedded simulator for the mission's world, or returns nullptr if the command line names a server; either
/// way `run_options` are set accordingly.
Result<std::unique_ptr<app::HeadlessSimulator>>
serverFor(const mission::MissionOptions& options, const mission::Mission& plan, mission::RunOptions& run_options) {
    if (options.server) {
        if (!(options.faults.isEmpty() && plan.faults.empty()))
            return tl::unexpected(Error{"faults can be made in the embedded simulator only",
                                        options.server->host.toStdString(), "Leave out --connect, or the faults"});
        run_options.host = options.server->host;
        run_options.port = options.server->port;
        return nullptr;
    }
    auto faults = faultsOf(options, plan);
    if (!faults)
        return tl::unexpected(faults.error());
    auto simulator =
        app::HeadlessSimulator::start(QString::fromStdString(plan.world),
                                      {.seed = options.seed, .speed_x = options.speed_x, .faults = *std::move(faults)});
    if (!simulator)
        return tl::unexpected(mission::atValue(plan, "world", simulator.error()));
    run_options.port = (*simulator)->port();
    run_options.truth = (*simulator)->truth();
    run_options.world_extent = (*simulator)->extent();
    run_options.true_figures = [one = simulator->get()] { return one->figures(); };
    return simulator;
}

int run(const mission::MissionOptions& options, mission::Mission plan) {
    applyTo(plan, options);
    agent::PluginLoader plugins;
    plugins.scan(server::pluginFolders() + options.plugin_folders);
    mission::RunOptions run_options;
    run_options.seed = options.seed;
    run_options.result_folder = options.result_folder;
    run_options.recording = options.recording;
    run_options.behavior_host = server::behaviorHostProgram();
    const auto simulator = serverFor(options, plan, run_options);
    if (!simulator) {
        mission::RunSummary known = knownOf(options);
        known.mission = plan.name;
        known.behavior = plan.behavior;
        known.plan = plan.plan;
        return refuse(simulator.error(), known);
    }
    mission::MissionRunner runner(std::move(plan), plugins, std::move(run_options));
    ProgressBar bar;
    QObject::connect(&runner, &mission::MissionRunner::progressed, [&](const auto& progress) { bar.show(progress); });
    QObject::connect(&runner, &mission::MissionRunner::noticed, [&](const auto& notice) { bar.say(notice.text); });
    QObject::connect(&runner, &mission::MissionRunner::finished, qApp, [](int code) { QCoreApplication::exit(code); });
    if (*simulator)
        (*simulator)->onFault(&runner, [&](const QString& sentence) { runner.noteFault(sentence); });
    app::QuitSignals signals_;
    QObject::connect(&signals_, &app::QuitSignals::quit, &runner, &mission::MissionRunner::interrupt);
    runner.start();
    const int exit_code = QCoreApplication::exec();
    bar.say(runner.summary()["reason"].toString().toStdString());
    return end(exit_code, runner.summary());
}

} // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen"); // Pictures contain text, which needs a QGuiApplication.
    QGuiApplication application(argc, argv);
    QCoreApplication::setApplicationName("usar-mission");
    if (QCoreApplication::arguments().value(1) == "lines")
        return app::runLinesVerb(QCoreApplication::arguments().mid(1));
    if (QCoreApplication::arguments().value(1) == "check-plan")
        return app::runCheckPlanVerb(QCoreApplication::arguments().mid(1));
    if (QCoreApplication::arguments().value(1) == "plan-report")
        return app::runPlanReportVerb(QCoreApplication::arguments().mid(1));
    if (mission::isReplayVerb(QCoreApplication::arguments().value(1)))
        return app::runReplayVerb(QCoreApplication::arguments().mid(1));
    const auto options = mission::readMissionOptions(QCoreApplication::arguments().mid(1));
    if (!options)
        return refuse(options.error());
    if (options->help) {
        std::printf("%s", qPrintable(mission::missionHelp()));
        return 0;
    }
    auto plan = mission::readMissionFile(options->mission_file);
    return plan ? run(*options, *std::move(plan)) : refuse(plan.error(), knownOf(*options));
}
