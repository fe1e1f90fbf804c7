#include "app/cli/compare_verb.h"

#include <algorithm>

#include <QJsonDocument>

#include "app/cli/console.h"
#include "core/campaign/comparison/campaign_figures.h"
#include "core/campaign/comparison/compare_options.h"
#include "core/campaign/comparison/html_report.h"
#include "core/campaign/comparison/json_report.h"
#include "core/campaign/comparison/junit_report.h"
#include "core/campaign/comparison/single_report.h"
#include "core/campaign/comparison/text_report.h"
#include "core/campaign/comparison/trade_off.h"
#include "core/campaign/plan/campaign_writer.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

namespace {

Result<void> writeReport(const QString& path, const QByteArray& text) {
    return path.isEmpty() ? Result<void>() : campaign::writeWhole(path, text);
}

/// The candidate that was asked for, or else all that can be compared; tells which cannot.
Result<std::vector<std::string>> candidatesOf(const campaign::CompareOptions& options, const std::string& baseline,
                                              const campaign::CampaignFigures& figures) {
    if (!options.candidate.isEmpty())
        return std::vector{options.candidate.toStdString()};
    std::vector<std::string> candidates;
    std::optional<Error> trouble;
    for (const campaign::Candidate& one : campaign::candidatesFor(baseline, figures)) {
        if (one.trouble)
            trouble = one.trouble;
        else
            candidates.push_back(one.variant);
        if (one.trouble && figures.variants.size() > 2) // A single one is told as the error.
            complain(one.trouble->text());
    }
    if (!candidates.empty())
        return candidates;
    if (trouble)
        return tl::unexpected(*trouble);
    return failure("there is only one variant", options.folders.join(", ").toStdString(),
                   "Give the campaign another variant, or compare two campaigns");
}

Result<void> writeCurve(const campaign::CompareOptions& options, const campaign::CampaignFigures& figures) {
    if (options.curve.isEmpty())
        return {};
    const QByteArray picture = campaign::tradeOffPicture(campaign::tradeOffsOf(figures.runs), figures.title);
    if (picture.isEmpty())
        return failure(figures.variants.size() == 1
                           ? "no run was done that has a duration and an error or a coverage"
                           : "no mission has two variants with a duration and an error or a coverage",
                       options.folders.join(", ").toStdString(), "Leave out --curve");
    return writeReport(options.curve, picture);
}

void tellText(const QString& report, const campaign::CampaignFigures& figures) {
    const QString missing = campaign::missingRuns(figures);
    std::printf("%s%s", qPrintable(report), missing.isEmpty() ? "" : qPrintable('\n' + missing + '\n'));
}

/// A campaign of one variant has no verdict, but figures.
Result<int> reportSingle(const campaign::CompareOptions& options, const campaign::CampaignFigures& figures) {
    const campaign::SingleReport single{figures.runs, figures.title, figures.facts};
    if (auto written = writeReport(options.html, campaign::htmlReport(single)); !written)
        return tl::unexpected(written.error());
    if (auto written = writeCurve(options, figures); !written)
        return tl::unexpected(written.error());
    if (options.json)
        return end(0, campaign::jsonReport(single));
    tellText(campaign::textReport(single), figures);
    return 0;
}

Result<int> report(const campaign::CompareOptions& options) {
    const auto figures = campaign::readCampaigns(options.folders);
    if (!figures)
        return tl::unexpected(figures.error());
    if (auto written = writeReport(options.junit, campaign::junitReport(figures->runs, figures->title)); !written)
        return tl::unexpected(written.error());
    const bool is_single = figures->variants.size() == 1 && options.baseline.isEmpty() && options.candidate.isEmpty();
    if (is_single)
        return reportSingle(options, *figures);
    const std::string baseline =
        options.baseline.isEmpty() ? figures->variants.front() : options.baseline.toStdString();
    const auto candidates = candidatesOf(options, baseline, *figures);
    if (!candidates)
        return tl::unexpected(candidates.error());
    const auto comparisons = campaign::compareAll(figures->runs, baseline, *candidates);
    if (!comparisons)
        return tl::unexpected(comparisons.error());
    const campaign::CampaignReport all{*comparisons, figures->runs, figures->title, figures->facts};
    if (auto written = writeReport(options.html, campaign::htmlReport(all)); !written)
        return tl::unexpected(written.error());
    if (auto written = writeCurve(options, *figures); !written)
        return tl::unexpected(written.error());
    const int exit_code = campaign::exitCodeOf(*comparisons);
    if (options.json)
        return end(exit_code, campaign::jsonReport(all));
    tellText(campaign::textReport(*comparisons), *figures);
    return exit_code;
}

} // namespace

int runCompareVerb(const QStringList& arguments) {
    const auto options = campaign::readCompareOptions(arguments);
    const Result<int> exit_code = options.and_then(report);
    if (exit_code)
        return *exit_code;
    complain(exit_code.error().text());
    return mission::BadInput;
}

} // namespace usar::app
