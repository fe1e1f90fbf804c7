#include "app/cli/campaign_verb.h"

#include <chrono>
#include <memory>

#include <QCoreApplication>
#include <QDir>
#include <QTemporaryDir>
#include <QTimer>

#include "app/cli/console.h"
#include "app/cli/mission_flight.h"
#include "core/base/version.h"
#include "core/campaign/comparison/campaign_figures.h"
#include "core/campaign/comparison/junit_report.h"
#include "core/campaign/comparison/until_decided.h"
#include "core/campaign/plan/campaign_writer.h"
#include "core/campaign/runs/campaign_start.h"
#include "core/campaign/runs/campaign_words.h"
#include "core/campaign/runs/shrinking.h"
#include "core/campaign/runs/slurm_script.h"
#include "core/mission/files/mission_check.h"
#include "core/mission/reports/progress_bar.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"
#include "core/sim/world/world_generator.h"

namespace usar::app {

namespace {

std::vector<campaign::FaultChoice> faultChoices() {
    std::vector<campaign::FaultChoice> choices;
    for (const sim::FaultDescription& kind : sim::faultKinds()) {
        campaign::FaultChoice choice{std::string(kind.word), {}};
        for (const sim::FaultNumber& number : kind.numbers)
            choice.numbers.push_back(
                {std::string(number.name), number.smallest, number.usual, number.largest, number.whole});
        choices.push_back(std::move(choice));
    }
    return choices;
}

/// The generators read no file that changes, so a name with a known generator is enough.
Result<QString> findWorld(const QString& name) {
    const auto seeded = server::seededWorld(name);
    if (!seeded)
        return server::findWorld(name);
    if (const auto known = sim::checkGenerator(seeded->generator.toStdString()); !known)
        return tl::unexpected(known.error());
    return QString();
}

campaign::CampaignHost hostOfCampaigns() {
    const auto loaded = std::make_shared<Preloaded>();
    return {
        .program = QCoreApplication::applicationFilePath(),
        .version = std::string(version()),
        .plugin_folders = server::pluginFolders(),
        .robots_folder = server::robotsFolder(),
        .faults = faultChoices(),
        .check_fault = [](const std::string& fault) { return sim::readFault(fault).map([](const sim::Fault&) {}); },
        .find_world = findWorld,
        .check_mission =
            [loaded](const mission::Mission& mission) {
                return mission::prepareBehavior(mission, loaded->plugins({})).map([](const mission::PreparedBehavior&) {
                });
            }};
}

int refuse(const Error& error) {
    complain(error.text());
    return end(mission::BadInput, {{"complete", false}, {"reason", QString::fromStdString(error.text())}});
}

/// Follows the runner's results and stops it when it is decided which variant is better.
class UntilDecided {
public:
    explicit UntilDecided(campaign::CampaignRunner& runner)
        : runner_(runner)
        , watch_(runner.campaign().variants.at(0).name, runner.campaign().variants.at(1).name) {
        for (const campaign::RunResult& result : runner.earlier())
            take(result);
    }

    void take(const campaign::RunResult& result) {
        watch_.take(result);
        if (watch_.verdict() != campaign::SequentialVerdict::Undecided)
            runner_.startNoMore();
    }

    /// "better", "worse" or "undecided", of the second variant.
    QString word() const {
        switch (watch_.verdict()) {
        case campaign::SequentialVerdict::Better:
            return "better";
        case campaign::SequentialVerdict::Worse:
            return "worse";
        case campaign::SequentialVerdict::Undecided:
            break;
        }
        return "undecided";
    }

private:
    campaign::CampaignRunner& runner_;
    campaign::DecisionWatch watch_;
};

/// Adds the runs that break an invariant to the file that the command line names, each with as few faults as possible
/// and as soon as they are known: shrinking may take longer than the campaign. Ends early once `stopped` is true.
Result<void> keepUnsound(const campaign::CampaignOptions& options, const campaign::CampaignRunner& runner,
                         const bool& stopped) {
    const campaign::Campaign& campaign = runner.campaign();
    const QString folder =
        options.folder +
        QString("/shrinking-%1").arg(options.shard.value_or(campaign::Shard{}).index, 3, 10, QChar('0'));
    for (const auto& [run, result] : runner.unsound()) {
        tell("Run " + std::to_string(run.number) + " is flown with fewer faults.\n");
        campaign::PlannedRun fewer = run;
        fewer.faults = campaign::shrunk(run.faults, [&](const campaign::FaultTexts& faults) {
            campaign::PlannedRun tried = run;
            tried.faults = faults;
            return !stopped &&
                   campaign::breaksAsBefore(campaign, tried, result, QCoreApplication::applicationFilePath(), folder);
        });
        if (stopped)
            break;
        if (auto added = campaign::addKnownFailures(options.shrink, {campaign::knownFailure(campaign, fewer, result)});
            !added)
            return added;
    }
    return {};
}

/// Whether what is only written in the end can be written: it is said now, and not when the campaign is flown.
Result<void> checkOutputs(const campaign::CampaignOptions& options) {
    if (!options.shrink.isEmpty())
        if (auto writable = campaign::addKnownFailures(options.shrink, {}); !writable)
            return writable;
    return options.junit.isEmpty() ? Result<void>() : campaign::writeWhole(options.junit, {});
}

Result<void> writeJunit(const campaign::CampaignOptions& options) {
    if (options.junit.isEmpty())
        return {};
    return campaign::readCampaigns({options.folder}).and_then([&](const campaign::CampaignFigures& figures) {
        return campaign::writeWhole(options.junit, campaign::junitReport(figures.runs, figures.title));
    });
}

/// `keeps`: the results outlast the program.
int fly(const campaign::CampaignOptions& options, bool keeps) {
    if (const auto possible = checkOutputs(options); !possible)
        return refuse(possible.error());
    const auto started = campaign::startCampaign(options, hostOfCampaigns());
    if (!started)
        return refuse(started.error());
    campaign::CampaignRunner& runner = **started;
    std::optional<UntilDecided> until_decided;
    if (options.until_decided) {
        if (runner.campaign().variants.size() != 2)
            return refuse({"only a campaign of two variants can be decided", options.file.toStdString(),
                           "Leave out --until-decided"});
        until_decided.emplace(runner);
    }
    mission::ProgressBar bar(isTerminal());
    const auto showProgress = [&] {
        const campaign::CampaignProgress progress = runner.progress();
        const double percent = progress.runs > 0 ? 100.0 * progress.done / progress.runs : 100.0;
        tell(bar.draw(percent, terminalColumns(),
                      [&](std::optional<std::size_t> columns) { return campaign::progressLine(progress, columns); }));
    };
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, showProgress);
    timer.start(std::chrono::milliseconds(200));
    QObject::connect(&runner, &campaign::CampaignRunner::ran, [&](const campaign::RunResult& result) {
        if (until_decided)
            until_decided->take(result);
        if (const std::string said = campaign::sentenceOf(result); !said.empty())
            tell(bar.say(said));
    });
    QObject::connect(&runner, &campaign::CampaignRunner::finished, qApp, &QCoreApplication::quit);
    server::QuitSignals signals_;
    QObject::connect(&signals_, &server::QuitSignals::quit, &runner, &campaign::CampaignRunner::interrupt);
    bool stopped = false;
    QObject::connect(&signals_, &server::QuitSignals::quit, &runner, [&stopped] { stopped = true; });
    runner.start();
    QCoreApplication::exec();
    timer.stop();
    showProgress();
    if (runner.trouble())
        return refuse(*runner.trouble());
    const bool whole = runner.progress().done == runner.progress().runs;
    if (stopped && !whole)
        tell(campaign::stoppedSentence(runner.progress(), keeps) + "\n");
    if (!options.shrink.isEmpty() && !whole)
        tell("Nothing is shrunk, because not all runs are flown.\n");
    else if (!options.shrink.isEmpty())
        if (const auto kept = keepUnsound(options, runner, stopped); !kept)
            return refuse(kept.error());
    if (const auto written = writeJunit(options); !written)
        return refuse(written.error());
    const campaign::CampaignProgress progress = runner.progress();
    QJsonObject summary = campaign::toJson(progress, options.folder);
    if (until_decided)
        summary["decided"] = until_decided->word();
    const bool decided = until_decided && until_decided->word() != "undecided";
    return end(campaign::exitCodeOf(progress, decided), summary);
}

/// Tests whose results nobody wants to keep are flown in a folder that is removed afterwards.
int flyInScratch(campaign::CampaignOptions options) {
    const QTemporaryDir scratch;
    if (!scratch.isValid())
        return refuse({"there is no place for the results: " + scratch.errorString().toStdString(),
                       QDir::tempPath().toStdString(), "Make room there, or name a folder with --out"});
    options.folder = scratch.path();
    return fly(options, false);
}

} // namespace

int runCampaignVerb(const QStringList& arguments) {
    const auto options = campaign::readCampaignOptions(arguments);
    if (!options)
        return refuse(options.error());
    if (!options->slurm)
        return options->folder.isEmpty() ? flyInScratch(*options) : fly(*options, true);
    if (const auto campaign = campaign::readCampaignFile(options->file); !campaign)
        return refuse(campaign.error()); // Otherwise each of the parts would say it, days later.
    std::printf("%s", qPrintable(campaign::slurmScript(*options, QCoreApplication::applicationFilePath())));
    return mission::Done;
}

} // namespace usar::app
