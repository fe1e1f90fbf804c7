#include "core/campaign/comparison/verdict_words.h"

#include "core/campaign/comparison/report.h"

namespace usar::campaign {

namespace {

QString detailOf(const QString& baseline, const QString& candidate, const QString& difference, const QString& interval,
                 const QString& more) {
    const QString text = QString("%1 against %2: %3 (%4)").arg(candidate, baseline, difference, interval);
    return more.isEmpty() ? text : text + "; " + more;
}

} // namespace

std::vector<VerdictLine> verdictLines(const Comparison& comparison) {
    const SuccessComparison& success = comparison.success;
    const Count before = success.count.baseline(), after = success.count.candidate();
    std::vector<VerdictLine> lines{
        {"Success", wordOf(success.verdict),
         detailOf(amount(before), amount(after), percent(after.rate() - before.rate(), true) + " points",
                  percent(success.difference.low, true) + " to " + percent(success.difference.high, true),
                  outlook(success.more_pairs))}};
    for (const MetricComparison& one : comparison.metrics)
        lines.push_back({QString::fromStdString(one.metric.title), wordOf(one.verdict),
                         detailOf(amount(one.baseline_median, one.metric), amount(one.candidate_median, one.metric),
                                  amount(one.difference, one.metric, true), amount(one.interval, one.metric),
                                  outlook(one.more_pairs))});
    return lines;
}

} // namespace usar::campaign
