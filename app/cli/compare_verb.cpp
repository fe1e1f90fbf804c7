#include "app/cli/compare_verb.h"

#include <algorithm>

#include <QJsonDocument>

#include "app/cli/console.h"
#include "core/campaign/comparison/campaign_figures.h"
#include "core/campaign/comparison/compare_options.h"
#include "core/campaign/comparison/html_report.h"
#include "core/campaign/comparison/json_report.h"
#include "core/campaign/comparison/junit_report.h"
#include "core/campaign/comparison/text_report.h"
#include "core/campaign/plan/campaign_writer.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

namespace {

Result<void> writeReport(const QString& path, const QByteArray& text) {
    return path.isEmpty() ? Result<void>() : campaign::writeWhole(path, text);
}

/// The first variant, and the first of the others; with two campaigns the first of the second one.
campaign::CompareOptions withNames(campaign::CompareOptions options, const std::vector<std::string>& variants) {
    if (options.baseline.isEmpty())
        options.baseline = QString::fromStdString(variants.front());
    const auto other = std::ranges::find_if(
        variants, [&](const std::string& variant) { return variant != options.baseline.toStdString(); });
    if (options.candidate.isEmpty() && other != variants.end())
        options.candidate = QString::fromStdString(*other);
    return options;
}

Result<int> report(const campaign::CompareOptions& typed) {
    const auto figures = campaign::readCampaigns(typed.folders);
    if (!figures)
        return tl::unexpected(figures.error());
    const campaign::CompareOptions options = withNames(typed, figures->variants);
    if (auto written = writeReport(options.junit, campaign::junitReport(figures->runs, figures->title)); !written)
        return tl::unexpected(written.error());
    if (options.candidate.isEmpty())
        return failure("there is only one variant", options.folders.join(", ").toStdString(),
                       "Give the campaign another variant, or compare two campaigns");
    const auto comparison =
        campaign::compare(figures->runs, options.baseline.toStdString(), options.candidate.toStdString());
    if (!comparison)
        return tl::unexpected(comparison.error());
    const campaign::Report report{*comparison, figures->runs, figures->title, figures->facts};
    if (auto written = writeReport(options.html, campaign::htmlReport(report)); !written)
        return tl::unexpected(written.error());
    if (options.json)
        return end(comparison->exitCode(), campaign::jsonReport(report));
    std::printf("%s", qPrintable(campaign::textReport(*comparison)));
    return comparison->exitCode();
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
