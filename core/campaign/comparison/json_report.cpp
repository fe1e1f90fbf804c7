#include "core/campaign/comparison/json_report.h"

#include <cmath>

#include <QJsonArray>

namespace usar::campaign {

namespace {

QJsonValue finite(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

QJsonValue json(std::size_t count) {
    return static_cast<qint64>(count);
}

QJsonValue json(const std::optional<std::size_t>& count) {
    return count ? json(*count) : QJsonValue(QJsonValue::Null);
}

QJsonValue json(const std::optional<double>& value) {
    return value ? finite(*value) : QJsonValue(QJsonValue::Null);
}

QJsonValue json(const std::string& text) {
    return QString::fromStdString(text);
}

QJsonObject json(const Count& count, const Interval& interval) {
    return {{"successes", json(count.successes)},
            {"trials", json(count.trials)},
            {"rate", count.rate()},
            {"low", interval.low},
            {"high", interval.high}};
}

QJsonArray json(const std::vector<RunPair>& differing) {
    QJsonArray list;
    for (const RunPair& pair : differing)
        list.append(QJsonObject{{"mission", json(pair.baseline->mission)},
                                {"pair", json(pair.baseline->pair)},
                                {"seed", static_cast<qint64>(pair.baseline->seed)},
                                {"baseline", wordOf(pair.baseline->outcome)},
                                {"candidate", wordOf(pair.candidate->outcome)}});
    return list;
}

QJsonObject json(const SuccessComparison& success) {
    const Count before = success.count.baseline(), after = success.count.candidate();
    return {{"baseline", json(before, success.baseline)},
            {"candidate", json(after, success.candidate)},
            {"difference", after.rate() - before.rate()},
            {"low", success.difference.low},
            {"high", success.difference.high},
            {"p", success.p},
            {"holm_p", success.holm_p},
            {"verdict", wordOf(success.verdict)},
            {"not_worse", success.not_worse},
            {"more_seeds", json(success.more_seeds)},
            {"differing", json(success.differing)}};
}

QJsonObject json(const MetricComparison& result) {
    return {{"key", json(result.metric.key)},
            {"unit", json(result.metric.unit)},
            {"lower_is_better", result.metric.lower_is_better},
            {"estimator", result.metric.estimator()},
            {"pairs", json(result.pairs())},
            {"left_out", json(result.values.left_out)},
            {"baseline_unfinished", json(result.baseline_unfinished)},
            {"candidate_unfinished", json(result.candidate_unfinished)},
            {"limit_assumed", json(result.values.assumed)},
            {"baseline_restricted_mean", json(result.baseline_restricted)},
            {"candidate_restricted_mean", json(result.candidate_restricted)},
            {"baseline_median", finite(result.baseline_median)},
            {"candidate_median", finite(result.candidate_median)},
            {"median_difference", finite(result.median_difference)},
            {"difference", finite(result.difference)},
            {"low", finite(result.interval.low)},
            {"high", finite(result.interval.high)},
            {"margin", result.margin},
            {"p", result.p},
            {"holm_p", result.holm_p},
            {"correlation", finite(result.correlation)},
            {"variance_ratio", finite(result.variance_ratio)},
            {"ratio", finite(result.ratio)},
            {"improved", finite(result.improved)},
            {"verdict", wordOf(result.verdict)},
            {"not_worse", result.not_worse},
            {"more_seeds", json(result.more_seeds)}};
}

QJsonArray namesOf(const std::vector<std::string>& names) {
    QJsonArray list;
    for (const std::string& name : names)
        list.append(json(name));
    return list;
}

QJsonObject factsOf(const std::vector<std::pair<std::string, std::string>>& facts) {
    QJsonObject object;
    for (const auto& [name, value] : facts)
        object[QString::fromStdString(name)] = json(value);
    return object;
}

} // namespace

QJsonObject jsonReport(const Report& report) {
    const Comparison& comparison = report.comparison;
    QJsonArray metrics;
    for (const MetricComparison& metric : comparison.metrics)
        metrics.append(json(metric));
    return {{"title", json(report.title)},
            {"baseline", json(comparison.baseline)},
            {"candidate", json(comparison.candidate)},
            {"overall", wordOf(comparison.overall)},
            {"exit_code", comparison.exitCode()},
            {"more_seeds", json(comparison.moreSeeds())},
            {"confidence", 1.0 - comparison.options.alpha},
            {"pairs", json(comparison.pairing.pairs.size())},
            {"single_runs", json(comparison.pairing.single)},
            {"pairs_not_counted", json(comparison.pairing.not_counted)},
            {"repeated_runs", json(comparison.pairing.repeated)},
            {"missions", namesOf(comparison.pairing.missions)},
            {"success", json(comparison.success)},
            {"metrics", metrics},
            {"facts", factsOf(report.facts)}};
}

QJsonObject jsonReport(const CampaignReport& report) {
    if (report.comparisons.size() == 1)
        return jsonReport({report.comparisons.front(), report.runs, report.title, report.facts});
    QJsonArray comparisons;
    for (const Comparison& comparison : report.comparisons) {
        QJsonObject one = jsonReport({comparison, report.runs, report.title, {}});
        one.remove("facts");
        comparisons.append(one);
    }
    return {{"title", json(report.title)},
            {"baseline", json(report.comparisons.front().baseline)},
            {"exit_code", exitCodeOf(report.comparisons)},
            {"comparisons", comparisons},
            {"facts", factsOf(report.facts)}};
}

} // namespace usar::campaign
