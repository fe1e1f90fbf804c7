#include "core/campaign/comparison/html_report.h"

#include <algorithm>

#include "core/campaign/comparison/course_plots.h"
#include "core/campaign/comparison/coverage_band.h"
#include "core/campaign/comparison/failures.h"
#include "core/campaign/comparison/html_parts.h"
#include "core/campaign/comparison/svg_plots.h"
#include "core/campaign/comparison/trade_off.h"

namespace usar::campaign {

namespace {

constexpr std::size_t differing_shown = 10;

QString styleOf(Verdict verdict) {
    return "word " + QString(wordOf(verdict)).replace(' ', '-');
}

/// The word of a comparison, and how much stands behind it.
void writeLead(QXmlStreamWriter& xml, const Comparison& comparison) {
    const HtmlElement line(xml, "p", "lead");
    write(xml, "span", wordOf(comparison.overall), styleOf(comparison.overall));
    QString words = QString(" %1 pairs of runs on equal seeds in %2 %3.")
                        .arg(comparison.pairing.pairs.size())
                        .arg(comparison.pairing.missions.size())
                        .arg(comparison.pairing.missions.size() == 1 ? "mission" : "missions");
    if (const QString more = outlook(comparison.moreSeeds());
        comparison.overall == Verdict::Undecided && !more.isEmpty())
        words += ' ' + more.left(1).toUpper() + more.mid(1) + '.';
    xml.writeCharacters(words);
}

/// "3 variants against cpp", or of one candidate its headline.
QString titleOf(const std::vector<Comparison>& comparisons) {
    const Comparison& first = comparisons.front();
    return comparisons.size() == 1
               ? headline(first)
               : QString("%1 variants against %2").arg(comparisons.size()).arg(nameOf(first.baseline));
}

void writeHeader(QXmlStreamWriter& xml, const CampaignReport& report) {
    const HtmlElement header(xml, "header");
    write(xml, "p", nameOf(report.title), "eyebrow");
    write(xml, "h1", titleOf(report.comparisons) + '.');
    if (report.comparisons.size() == 1)
        return writeLead(xml, report.comparisons.front());
    const HtmlElement list(xml, "ul", "overview");
    for (std::size_t i = 0; i < report.comparisons.size(); ++i) {
        const Comparison& comparison = report.comparisons[i];
        const HtmlElement item(xml, "li");
        write(xml, "span", wordOf(comparison.overall), styleOf(comparison.overall));
        writeWith(xml, "a", {"href", QString("#candidate-%1").arg(i + 1)}, headline(comparison));
    }
}

void writeTradeOffs(QXmlStreamWriter& xml, const std::vector<RunFigures>& runs) {
    const std::vector<TradeOff> trade_offs = tradeOffsOf(runs);
    if (trade_offs.empty())
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Time against error and coverage");
    {
        const HtmlElement grid(xml, "div", "plots");
        for (const TradeOff& trade_off : trade_offs) {
            const HtmlElement figure(xml, "figure");
            drawTradeOff(xml, trade_off);
        }
    }
    write(xml, "p",
          "Each variant has its medians at the dot; its cross is as wide and high as the middle half of its runs that "
          "were done.",
          "note");
}

/// One line of the table of verdicts.
struct VerdictRow {
    QString title;
    Verdict verdict;
    QString more;
    QList<QStringList> figures; ///< baseline, candidate, difference, p, pairs, r; some with a second line
    std::function<void()> draw;
};

void writeRow(QXmlStreamWriter& xml, const VerdictRow& row) {
    const HtmlElement line(xml, "tr");
    write(xml, "th", row.title);
    {
        const HtmlElement cell(xml, "td");
        write(xml, "span", wordOf(row.verdict), styleOf(row.verdict));
        if (!row.more.isEmpty())
            write(xml, "div", row.more, "more");
    }
    {
        const HtmlElement cell(xml, "td");
        row.draw();
    }
    for (const QStringList& figure : row.figures) {
        const HtmlElement cell(xml, "td", "figure");
        xml.writeCharacters(figure.front());
        if (figure.size() > 1)
            write(xml, "div", figure.back(), "more");
    }
}

void writeSuccess(QXmlStreamWriter& xml, const Comparison& comparison) {
    const SuccessComparison& success = comparison.success;
    const Count before = success.count.baseline(), after = success.count.candidate();
    const auto rate = [](const Count& count, const Interval& interval) {
        return QStringList{amount(count), QString("%1 to %2 %").arg(percent(interval.low), percent(interval.high))};
    };
    writeRow(xml, {"Success",
                   success.verdict,
                   outlook(success.more_seeds),
                   {rate(before, success.baseline),
                    rate(after, success.candidate),
                    {percent(after.rate() - before.rate(), true) + " points",
                     percent(success.difference.low, true) + " to " + percent(success.difference.high, true)},
                    {pValue(success.holm_p)},
                    {QString::number(success.count.pairs())},
                    {""}},
                   [&] { drawInterval(xml, success, comparison.options.success_margin); }});
}

/// The median, and below it the mean to the limit where a run was not done.
QStringList medianOf(const MetricComparison& result, double median, const std::optional<double>& restricted) {
    QStringList lines{amount(median, result.metric)};
    if (restricted)
        lines << "mean " + restrictionOf(result) + ": " + amount(*restricted, result.metric);
    return lines;
}

void writeMetric(QXmlStreamWriter& xml, const MetricComparison& result) {
    QStringList pairs{QString::number(result.pairs())};
    if (result.values.left_out > 0)
        pairs << QString("%1 left out").arg(result.values.left_out);
    writeRow(xml, {QString::fromStdString(result.metric.title),
                   result.verdict,
                   outlook(result.more_seeds),
                   {medianOf(result, result.baseline_median, result.baseline_restricted),
                    medianOf(result, result.candidate_median, result.candidate_restricted),
                    {amount(result.difference, result.metric, true), amount(result.interval, result.metric)},
                    {pValue(result.holm_p)},
                    pairs,
                    {plain(result.correlation)}},
                   [&] { drawInterval(xml, result); }});
}

void writeVerdicts(QXmlStreamWriter& xml, const Comparison& comparison) {
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Verdicts");
    {
        const HtmlElement table(xml, "table", "verdicts");
        writeHead(xml, {"", "Word", "Worse \u2190 \u2192 better", nameOf(comparison.baseline),
                        nameOf(comparison.candidate), "Difference", "p", "Pairs", "r"});
        const HtmlElement body(xml, "tbody");
        writeSuccess(xml, comparison);
        for (const MetricComparison& metric : comparison.metrics)
            writeMetric(xml, metric);
    }
    write(
        xml, "p",
        QString("Both variants have their median; the difference is the interquartile mean of the paired differences, "
                "for charges and collisions their mean, with its %1 % interval. The shaded band is the margin within "
                "which a difference does not matter: an interval wholly within it is equal, one wholly beyond it is "
                "better or worse. p is Wilcoxon's, for success McNemar's, after Holm over all figures of all "
                "candidates; the intervals are those of each figure alone. r tells how much of a run is "
                "due to its seed. A run that was not done counts its time limit as its duration, or without one the "
                "longest time of any run of its mission.")
            .arg(100.0 * (1.0 - comparison.options.alpha)),
        "note");
    for (const QString& sentence : omissions(comparison))
        write(xml, "p", sentence, "note");
}

/// "Duration, s · better on 73 seeds, worse on 27"
QString captionOf(const MetricComparison& result) {
    const auto is = [](double sign) { return [sign](double difference) { return sign * difference > 0.0; }; };
    const std::vector<double>& all = result.sorted_differences;
    const auto fewer = std::count_if(all.begin(), all.end(), is(-1.0)),
               more = std::count_if(all.begin(), all.end(), is(1.0));
    const bool lower_is_better = result.metric.lower_is_better;
    const QString unit = QString::fromStdString(result.metric.unit);
    return QString::fromStdString(result.metric.title) + (unit.isEmpty() ? QString() : ", " + unit) +
           QString(" \u00b7 better on %1 seeds, worse on %2")
               .arg(lower_is_better ? fewer : more)
               .arg(lower_is_better ? more : fewer);
}

void writeDifferences(QXmlStreamWriter& xml, const Comparison& comparison) {
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Difference of each pair, sorted");
    QStringList same;
    {
        const HtmlElement grid(xml, "div", "plots");
        for (const MetricComparison& result : comparison.metrics) {
            if (result.sorted_differences.front() == 0.0 && result.sorted_differences.back() == 0.0) {
                same << QString::fromStdString(result.metric.title);
                continue;
            }
            const HtmlElement figure(xml, "figure");
            write(xml, "figcaption", captionOf(result));
            drawDifferences(xml, result);
        }
    }
    if (!same.isEmpty())
        write(xml, "p", "The same on all seeds: " + same.join(", ") + '.', "note");
}

std::vector<const RunFigures*> sideOf(const Comparison& comparison, const RunFigures* RunPair::*side) {
    std::vector<const RunFigures*> runs;
    for (const RunPair& pair : comparison.pairing.pairs)
        runs.push_back(pair.*side);
    return runs;
}

VariantRuns runsOf(const Comparison& comparison, const RunFigures* RunPair::*side, const std::string& variant,
                   int mission) {
    VariantRuns all{nameOf(variant), {}};
    for (const RunPair& pair : comparison.pairing.pairs)
        if (pair.mission == mission)
            all.runs.push_back(pair.*side);
    return all;
}

void writeCourses(QXmlStreamWriter& xml, const Comparison& comparison) {
    for (std::size_t i = 0; i < comparison.pairing.missions.size(); ++i) {
        const QString mission = nameOf(comparison.pairing.missions[i]);
        const int index = static_cast<int>(i);
        const VariantRuns baseline = runsOf(comparison, &RunPair::baseline, comparison.baseline, index);
        const VariantRuns candidate = runsOf(comparison, &RunPair::candidate, comparison.candidate, index);
        writeCourse(xml, mission, baseline, candidate);
    }
}

void writeNotableRuns(QXmlStreamWriter& xml, const Comparison& comparison) {
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Runs to look at");
    const std::vector<RunPair>& differing = comparison.success.differing;
    std::vector<const RunFigures*> unlucky;
    for (const RunPair& pair : differing)
        if (unlucky.size() < differing_shown)
            unlucky.push_back(pair.baseline->outcome == Outcome::Done ? pair.candidate : pair.baseline);
    if (!unlucky.empty()) {
        writeRuns(xml, "Not done, though the other variant was, on the same seed", unlucky);
        writeCut(xml, unlucky.size(), differing.size());
    }
    writeRuns(xml, "The worst of all", worstRuns(comparison, most_worst_runs));
}

/// All that is to be said of one candidate.
void writeComparison(QXmlStreamWriter& xml, const Report& report) {
    writeVerdicts(xml, report.comparison);
    if (!report.comparison.metrics.empty())
        writeDifferences(xml, report.comparison);
    writeProfile(xml, {nameOf(report.comparison.baseline), sideOf(report.comparison, &RunPair::baseline)},
                 {nameOf(report.comparison.candidate), sideOf(report.comparison, &RunPair::candidate)});
    writeCourses(xml, report.comparison);
    writeNotableRuns(xml, report.comparison);
    writeFailures(xml, failureGroups(report.comparison, report.runs),
                  {nameOf(report.comparison.baseline), nameOf(report.comparison.candidate)});
}

void writeCandidate(QXmlStreamWriter& xml, const CampaignReport& report, std::size_t index) {
    const Comparison& comparison = report.comparisons[index];
    const HtmlElement article(xml, "article");
    writeWith(xml, "h1", {"id", QString("candidate-%1").arg(index + 1)}, headline(comparison) + '.');
    writeLead(xml, comparison);
    writeComparison(xml, {comparison, report.runs, report.title, {}});
}

} // namespace

QByteArray htmlReport(const Report& report) {
    const std::vector<Comparison> one{report.comparison};
    return htmlReport(CampaignReport{one, report.runs, report.title, report.facts});
}

QByteArray htmlReport(const CampaignReport& report) {
    return pageOf(titleOf(report.comparisons), [&](QXmlStreamWriter& xml) {
        writeHeader(xml, report);
        writeTradeOffs(xml, report.runs);
        if (report.comparisons.size() == 1)
            writeComparison(xml, {report.comparisons.front(), report.runs, report.title, report.facts});
        else
            for (std::size_t i = 0; i < report.comparisons.size(); ++i)
                writeCandidate(xml, report, i);
        writeFacts(xml, report.facts);
    });
}

} // namespace usar::campaign
