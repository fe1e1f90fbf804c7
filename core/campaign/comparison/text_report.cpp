#include "core/campaign/comparison/text_report.h"

#include <QStringList>

#include "core/campaign/comparison/report.h"

namespace usar::campaign {

namespace {

using Rows = std::vector<QStringList>;

QStringList successRow(const Comparison& comparison) {
    const SuccessComparison& success = comparison.success;
    const Count before = success.count.baseline(), after = success.count.candidate();
    return {"Success",
            wordOf(success.verdict),
            amount(before),
            amount(after),
            percent(after.rate() - before.rate(), true) + " points",
            percent(success.difference.low, true) + " to " + percent(success.difference.high, true),
            pValue(success.holm_p),
            "",
            QString::number(success.count.pairs()),
            outlook(success.more_seeds)};
}

QStringList metricRow(const MetricComparison& result) {
    return {QString::fromStdString(result.metric.title),
            wordOf(result.verdict),
            amount(result.baseline_median, result.metric),
            amount(result.candidate_median, result.metric),
            amount(result.difference, result.metric, true) + ' ' + result.metric.estimator(),
            amount(result.interval, result.metric),
            pValue(result.holm_p),
            plain(result.correlation),
            QString::number(result.pairs()),
            outlook(result.more_seeds)};
}

/// Each column as wide as its widest cell. The last one is not filled up, so that no line ends with blanks.
QString aligned(const Rows& rows) {
    QList<qsizetype> widths(rows.front().size(), 0);
    for (const QStringList& row : rows)
        for (qsizetype i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    QString text;
    for (const QStringList& row : rows) {
        QString line;
        for (qsizetype i = 0; i < row.size(); ++i)
            line += row[i].leftJustified(widths[i]) + "  ";
        while (line.endsWith(' '))
            line.chop(1);
        text += line + '\n';
    }
    return text;
}

} // namespace

QString textReport(const Comparison& comparison) {
    const QString confidence = QString::number(100.0 * (1.0 - comparison.options.alpha)) + " %";
    Rows rows{{"", "word", nameOf(comparison.baseline), nameOf(comparison.candidate), "difference", confidence,
               "p (Holm)", "r", "pairs", ""},
              successRow(comparison)};
    for (const MetricComparison& metric : comparison.metrics)
        rows.push_back(metricRow(metric));
    QString text = headline(comparison) + ".\n\n" + aligned(rows) + '\n';
    for (const QString& sentence : omissions(comparison))
        text += sentence + '\n';
    for (const QString& sentence : differingSeeds(comparison))
        text += sentence + '\n';
    return text;
}

QString textReport(const std::vector<Comparison>& comparisons) {
    if (comparisons.size() == 1)
        return textReport(comparisons.front());
    QString text, headlines;
    for (const Comparison& comparison : comparisons) {
        text += textReport(comparison) + '\n';
        headlines += headline(comparison) + ".\n";
    }
    return text + headlines;
}

} // namespace usar::campaign
