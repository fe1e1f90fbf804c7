#include "app/cli/campaign_verb.h"

#include <chrono>

#include <QCoreApplication>
#include <QTimer>

#include "app/cli/console.h"
#include "core/base/version.h"
#include "core/campaign/comparison/until_decided.h"
#include "core/campaign/runs/campaign_start.h"
#include "core/campaign/runs/campaign_words.h"
#include "core/campaign/runs/shrinking.h"
#include "core/campaign/runs/slurm_script.h"
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
    return {.program = QCoreApplication::applicationFilePath(),
            .version = std::string(version()),
            .plugin_folders = server::pluginFolders(),
            .faults = faultChoices(),
            .check_fault = [](const std::string& fault) { return sim::readFault(fault).map([](const sim::Fault&) {}); },
            .find_world = findWorld};
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

/// Writes the runs that break an invariant into the file that the command line names, with as few faults as possible.
Result<void> keepUnsound(const campaign::CampaignOptions& options, const campaign::CampaignRunner& runner) {
    if (options.shrink.isEmpty())
        return {};
    const campaign::Campaign& campaign = runner.campaign();
    std::vector<campaign::KnownFailure> failures;
    for (const auto& [run, result] : runner.unsound()) {
        tell("Run " + std::to_string(run.number) + " is flown with fewer faults.\n");
        campaign::PlannedRun fewer = run;
        fewer.faults = campaign::shrunk(run.faults, [&](const campaign::FaultTexts& faults) {
            campaign::PlannedRun tried = run;
            tried.faults = faults;
            return campaign::breaksInvariants(campaign, tried, QCoreApplication::applicationFilePath(),
                                              options.folder + "/shrinking", result.differences.has_value());
        });
        failures.push_back(campaign::knownFailure(campaign, fewer, result));
    }
    return campaign::addKnownFailures(options.shrink, failures);
}

int fly(const campaign::CampaignOptions& options) {
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
    runner.start();
    QCoreApplication::exec();
    showProgress();
    if (runner.trouble())
        return refuse(*runner.trouble());
    if (const auto kept = keepUnsound(options, runner); !kept)
        return refuse(kept.error());
    const campaign::CampaignProgress progress = runner.progress();
    QJsonObject summary = campaign::toJson(progress, options.folder);
    if (until_decided)
        summary["decided"] = until_decided->word();
    const bool decided = until_decided && until_decided->word() != "undecided";
    return end(campaign::exitCodeOf(progress, decided), summary);
}

} // namespace

int runCampaignVerb(const QStringList& arguments) {
    const auto options = campaign::readCampaignOptions(arguments);
    if (!options)
        return refuse(options.error());
    if (options->help)
        std::printf("%s", qPrintable(campaign::campaignHelp()));
    else if (options->slurm)
        std::printf("%s", qPrintable(campaign::slurmScript(*options, QCoreApplication::applicationFilePath())));
    else
        return fly(*options);
    return mission::Done;
}

} // namespace usar::app
