#include "core/campaign/runs/campaign_words.h"

#include <cmath>

#include <QJsonArray>

#include "core/base/numbers.h"
#include "core/base/time_range.h"
#include "core/campaign/runs/invariants.h"
#include "core/mission/reports/progress_bar.h"

namespace usar::campaign {

namespace {

QJsonArray listOf(const std::vector<int>& numbers) {
    QJsonArray list;
    for (const int number : numbers)
        list << number;
    return list;
}

} // namespace

std::string progressLine(const CampaignProgress& progress, std::optional<std::size_t> columns) {
    const double percent = progress.runs > 0 ? 100.0 * progress.done / progress.runs : 100.0;
    std::vector<std::string> figures;
    if (const int failures = progress.failures(); failures > 0)
        figures.push_back("  " + std::to_string(failures) + " not done");
    if (const auto unsound = progress.unsound.size(); unsound > 0)
        figures.push_back("  " + std::to_string(unsound) + " unsound");
    if (const double rate_hz = progress.rate_hz(); rate_hz > 0.0) {
        figures.push_back("  " + fixed(rate_hz, rate_hz < 10.0 ? 1 : 0) + " runs/s");
        figures.push_back("  ETA " + countdownText(Seconds{(progress.runs - progress.done) / rate_hz}));
    }
    const std::string runs = std::to_string(progress.done) + " of " + std::to_string(progress.runs) + " runs";
    return mission::barLine(percent, runs, figures, columns);
}

std::string sentenceOf(const RunResult& result) {
    std::string said;
    if (!result.broken.isEmpty())
        said = "shows a defect of the program. " + result.broken.join(' ').toStdString();
    else if (result.outcome != Outcome::Done)
        said = wordOf(result.outcome).toStdString() + ": " + result.reason;
    else
        return {};
    return "Run " + std::to_string(result.number) + " (" + result.mission + ", " + result.variant + ", seed " +
           std::to_string(result.seed) + ") " + said + "\n    " + result.command.toStdString();
}

std::string stoppedSentence(const CampaignProgress& progress, bool kept) {
    return "The campaign was stopped after " + std::to_string(progress.done) + " of " + std::to_string(progress.runs) +
           " runs." + (kept ? " The same command with --resume flies the others." : "");
}

QJsonObject toJson(const CampaignProgress& progress, const QString& folder) {
    QJsonObject outcomes;
    for (const auto& [outcome, count] : progress.outcomes)
        outcomes[wordOf(outcome)] = count;
    return {{"folder", folder},
            {"runs", progress.runs},
            {"done", progress.done},
            {"outcomes", outcomes},
            {"different", listOf(progress.different)},
            {"unsound", listOf(progress.unsound)},
            {"complete", progress.done == progress.runs},
            {"wall_s", std::round(progress.wall.count() * 1000.0) / 1000.0}};
}

int exitCodeOf(const CampaignProgress& progress, bool may_lack_runs) {
    const bool whole = may_lack_runs || progress.done == progress.runs;
    const bool well = whole && progress.failures() == 0 && progress.unsound.empty();
    return well ? mission::Done : mission::MissionFailed;
}

} // namespace usar::campaign
