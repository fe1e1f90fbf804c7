#include "app/cli/campaign_verb.h"

#include <chrono>

#include <QCoreApplication>
#include <QTimer>

#include "app/cli/console.h"
#include "core/base/version.h"
#include "core/campaign/runs/campaign_start.h"
#include "core/campaign/runs/campaign_words.h"
#include "core/campaign/runs/slurm_script.h"
#include "core/mission/reports/progress_bar.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"

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

campaign::CampaignHost hostOfCampaigns() {
    return {.program = QCoreApplication::applicationFilePath(),
            .version = std::string(version()),
            .plugin_folders = server::pluginFolders(),
            .faults = faultChoices(),
            .check_fault = [](const std::string& fault) { return sim::readFault(fault).map([](const sim::Fault&) {}); },
            .find_world = server::findWorld};
}

int refuse(const Error& error) {
    complain(error.text());
    return end(mission::BadInput, {{"complete", false}, {"reason", QString::fromStdString(error.text())}});
}

int fly(const campaign::CampaignOptions& options) {
    const auto started = campaign::startCampaign(options, hostOfCampaigns());
    if (!started)
        return refuse(started.error());
    campaign::CampaignRunner& runner = **started;
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
    const campaign::CampaignProgress progress = runner.progress();
    return end(campaign::exitCodeOf(progress), campaign::toJson(progress, options.folder));
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
