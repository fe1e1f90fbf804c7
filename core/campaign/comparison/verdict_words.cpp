#include "core/campaign/comparison/verdict_words.h"

#include "core/campaign/comparison/report.h"

namespace usar::campaign {

namespace {

/// These texts are shown about one figure.
struct Amounts {
    QString baseline;
    QString candidate;
    QString difference;
    QString interval;
};

QString detailOf(const Comparison& comparison, const Amounts& amounts, const std::optional<std::size_t>& more_seeds) {
    const QString text = QString("%1 %2, %3 %4; in pairs %5 (%6)")
                             .arg(nameOf(comparison.baseline), amounts.baseline, nameOf(comparison.candidate),
                                  amounts.candidate, amounts.difference, amounts.interval);
    const QString more = outlook(more_seeds);
    return more.isEmpty() ? text : text + "; " + more;
}

} // namespace

std::vector<VerdictLine> verdictLines(const Comparison& comparison) {
    const SuccessComparison& success = comparison.success;
    const Count before = success.count.baseline(), after = success.count.candidate();
    const Amounts rates{amount(before), amount(after), percent(after.rate() - before.rate(), true) + " points",
                        percent(success.difference.low, true) + " to " + percent(success.difference.high, true)};
    std::vector<VerdictLine> lines{
        {"Success", wordOf(success.verdict), detailOf(comparison, rates, success.more_seeds)}};
    for (const MetricComparison& one : comparison.metrics) {
        const Amounts amounts{amount(one.baseline_median, one.metric), amount(one.candidate_median, one.metric),
                              amount(one.difference, one.metric, true), amount(one.interval, one.metric)};
        lines.push_back({QString::fromStdString(one.metric.title), wordOf(one.verdict),
                         detailOf(comparison, amounts, one.more_seeds)});
    }
    return lines;
}

} // namespace usar::campaign
