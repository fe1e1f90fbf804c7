#include "core/campaign/comparison/html_report.h"

#include <algorithm>

#include "core/campaign/comparison/course_plots.h"
#include "core/campaign/comparison/coverage_band.h"
#include "core/campaign/comparison/failures.h"
#include "core/campaign/comparison/html_page.h"
#include "core/campaign/comparison/svg_plots.h"
#include "core/campaign/comparison/trade_off.h"

namespace usar::campaign {

extern const char comparison_style[]; // resources/reports/comparison.css

namespace {

constexpr std::size_t runs_shown = 10, differing_shown = 10, groups_shown = 12;

QString styleOf(Verdict verdict) {
    return "word " + QString(wordOf(verdict)).replace(' ', '-');
}

/// An element with one attribute and words in it.
void writeWith(QXmlStreamWriter& xml, const QString& name, const QXmlStreamAttribute& attribute, const QString& words) {
    xml.writeStartElement(name);
    xml.writeAttribute(attribute);
    xml.writeCharacters(words);
    xml.writeEndElement();
}

/// A paragraph that says so where a list was cut.
void writeCut(QXmlStreamWriter& xml, std::size_t shown, std::size_t all) {
    if (shown < all)
        write(xml, "p", QString("%1 of %2 are shown.").arg(shown).arg(all), "note");
}

/// The word of a comparison, and how much stands behind it.
void writeLead(QXmlStreamWriter& xml, const Comparison& comparison) {
    const HtmlElement line(xml, "p", "lead");
    write(xml, "span", wordOf(comparison.overall), styleOf(comparison.overall));
    QString words = QString(" %1 pairs of runs on equal seeds in %2 %3.")
                        .arg(comparison.pairing.pairs.size())
                        .arg(comparison.pairing.missions.size())
                        .arg(comparison.pairing.missions.size() == 1 ? "mission" : "missions");
    if (const QString more = outlook(comparison.morePairs());
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
                   outlook(success.more_pairs),
                   {rate(before, success.baseline),
                    rate(after, success.candidate),
                    {percent(after.rate() - before.rate(), true) + " points",
                     percent(success.difference.low, true) + " to " + percent(success.difference.high, true)},
                    {pValue(success.holm_p)},
                    {QString::number(success.count.pairs())},
                    {""}},
                   [&] { drawInterval(xml, success, comparison.options.success_margin); }});
}

void writeMetric(QXmlStreamWriter& xml, const MetricComparison& result) {
    QStringList pairs{QString::number(result.pairs())};
    if (result.values.left_out > 0)
        pairs << QString("%1 left out").arg(result.values.left_out);
    writeRow(xml, {QString::fromStdString(result.metric.title),
                   result.verdict,
                   outlook(result.more_pairs),
                   {{amount(result.baseline_median, result.metric)},
                    {amount(result.candidate_median, result.metric)},
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
                "due to its seed. A run that was not done counts its time limit as its duration.")
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

ProfileCurve curveOf(const Comparison& comparison, const RunFigures* RunPair::*side, const std::string& variant) {
    ProfileCurve curve{nameOf(variant), {}};
    for (const RunPair& pair : comparison.pairing.pairs)
        if (const RunFigures& run = *(pair.*side); run.outcome == Outcome::Done)
            if (const auto found = run.metrics.find("duration_s"); found != run.metrics.end() && found->second)
                curve.sorted.push_back(*found->second);
    std::sort(curve.sorted.begin(), curve.sorted.end());
    return curve;
}

void writeProfile(QXmlStreamWriter& xml, const Comparison& comparison) {
    const auto duration = std::find_if(comparison.metrics.begin(), comparison.metrics.end(),
                                       [](const MetricComparison& m) { return m.metric.key == "duration_s"; });
    if (duration == comparison.metrics.end())
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Share of the seeds that are done by each time");
    drawProfile(xml, curveOf(comparison, &RunPair::baseline, comparison.baseline),
                curveOf(comparison, &RunPair::candidate, comparison.candidate), comparison.pairing.pairs.size(),
                duration->metric);
}

VariantRuns runsOf(const Comparison& comparison, const RunFigures* RunPair::*side, const std::string& variant,
                   int mission) {
    VariantRuns all{nameOf(variant), {}};
    for (const RunPair& pair : comparison.pairing.pairs)
        if (pair.mission == mission)
            all.runs.push_back(pair.*side);
    return all;
}

void writeCoverage(QXmlStreamWriter& xml, const QString& mission, const VariantRuns& baseline,
                   const VariantRuns& candidate) {
    if (std::max(lastCoverage_s(baseline.runs), lastCoverage_s(candidate.runs)) <= 0.0)
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Coverage of " + mission + " over time");
    drawCoverage(xml, baseline, candidate);
    write(xml, "p",
          "The lines are medians; the bands reach from the tenth to the ninetieth percentile. A run that has ended "
          "keeps what it has covered.",
          "note");
}

void writePlaces(QXmlStreamWriter& xml, const QString& mission, const VariantRuns& baseline,
                 const VariantRuns& candidate) {
    if (!havePlaces(baseline, candidate))
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Where runs of " + mission + " collided or gave goals up");
    drawPlaces(xml, baseline, candidate);
    write(xml, "p", "Crosses are collisions, at most twenty of a run; circles are goals that were given up.", "note");
}

void writeCourses(QXmlStreamWriter& xml, const Comparison& comparison) {
    for (std::size_t i = 0; i < comparison.pairing.missions.size(); ++i) {
        const QString mission = nameOf(comparison.pairing.missions[i]);
        const int index = static_cast<int>(i);
        const VariantRuns baseline = runsOf(comparison, &RunPair::baseline, comparison.baseline, index);
        const VariantRuns candidate = runsOf(comparison, &RunPair::candidate, comparison.candidate, index);
        writeCoverage(xml, mission, baseline, candidate);
        writePlaces(xml, mission, baseline, candidate);
    }
}

/// A browser breaks a line before or after any hyphen, so each word of a command is kept in one piece.
void writeCommand(QXmlStreamWriter& xml, const std::string& command) {
    const HtmlElement code(xml, "code");
    bool is_first = true;
    for (const QString& word : printable(command).split(' ')) {
        xml.writeCharacters(is_first ? "" : " ");
        write(xml, "span", word);
        is_first = false;
    }
}

/// The seed, how it ended, why, what flies it again, and its map or its path.
void writeRun(QXmlStreamWriter& xml, const RunFigures& run) {
    const HtmlElement row(xml, "tr");
    write(xml, "td", QString::number(run.number), "figure");
    write(xml, "td", nameOf(run.variant));
    write(xml, "td", nameOf(run.mission) + ", pair " + QString::number(run.pair));
    write(xml, "td", wordOf(run.outcome));
    {
        const HtmlElement cell(xml, "td", "why");
        xml.writeCharacters(printable(run.reason));
        if (!run.command.empty())
            writeCommand(xml, run.command);
    }
    const HtmlElement cell(xml, "td", "drawing");
    if (!drawMap(xml, run))
        drawCourse(xml, run);
}

void writeRuns(QXmlStreamWriter& xml, const QString& title, const std::vector<const RunFigures*>& runs) {
    const HtmlElement table(xml, "table", "runs");
    write(xml, "caption", title);
    writeHead(xml, {"Run", "Variant", "Mission and pair", "Outcome", "Why, and how to fly it again", ""});
    const HtmlElement body(xml, "tbody");
    for (const RunFigures* run : runs)
        writeRun(xml, *run);
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
    writeRuns(xml, "The worst of all", worstRuns(comparison, runs_shown));
}

void writeFailures(QXmlStreamWriter& xml, const Report& report) {
    const std::vector<FailureGroup> groups = failureGroups(report.comparison, report.runs);
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Why runs were not done");
    if (groups.empty()) {
        write(xml, "p", "All runs were done.");
        return;
    }
    const std::size_t shown = std::min(groups.size(), groups_shown);
    {
        const HtmlElement table(xml, "table", "failures");
        writeHead(xml, {"Outcome", "Reason", nameOf(report.comparison.baseline), nameOf(report.comparison.candidate)});
        const HtmlElement body(xml, "tbody");
        for (std::size_t i = 0; i < shown; ++i) {
            const HtmlElement row(xml, "tr");
            write(xml, "td", wordOf(groups[i].outcome));
            write(xml, "td", groups[i].reason.empty() ? QString("no reason is known") : printable(groups[i].reason));
            write(xml, "td", QString::number(groups[i].of_baseline), "figure");
            write(xml, "td", QString::number(groups[i].of_candidate), "figure");
        }
    }
    writeCut(xml, shown, groups.size());
}

void writeFacts(QXmlStreamWriter& xml, const CampaignReport& report) {
    if (report.facts.empty())
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "How this was made");
    const HtmlElement table(xml, "table", "facts");
    const HtmlElement body(xml, "tbody");
    for (const auto& [name, value] : report.facts) {
        const HtmlElement row(xml, "tr");
        write(xml, "th", printable(name));
        write(xml, "td", printable(value));
    }
}

void writeHeadOfPage(QXmlStreamWriter& xml, const CampaignReport& report) {
    const HtmlElement head(xml, "head");
    xml.writeEmptyElement("meta");
    xml.writeAttribute("charset", "utf-8");
    xml.writeEmptyElement("meta");
    xml.writeAttribute("name", "viewport");
    xml.writeAttribute("content", "width=device-width, initial-scale=1");
    xml.writeEmptyElement("meta");
    xml.writeAttribute("name", "color-scheme");
    xml.writeAttribute("content", "light dark");
    write(xml, "title", titleOf(report.comparisons));
    // The style sheet has none of the characters that XML escapes, because HTML would not take them back there.
    write(xml, "style", comparison_style);
}

/// All that is to be said of one candidate.
void writeComparison(QXmlStreamWriter& xml, const Report& report) {
    writeVerdicts(xml, report.comparison);
    if (!report.comparison.metrics.empty())
        writeDifferences(xml, report.comparison);
    writeProfile(xml, report.comparison);
    writeCourses(xml, report.comparison);
    writeNotableRuns(xml, report.comparison);
    writeFailures(xml, report);
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
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.writeDTD("<!DOCTYPE html>\n");
    xml.writeStartElement("html");
    xml.writeAttribute("lang", "en");
    writeHeadOfPage(xml, report);
    {
        const HtmlElement body(xml, "body");
        const HtmlElement main(xml, "main");
        writeHeader(xml, report);
        writeTradeOffs(xml, report.runs);
        if (report.comparisons.size() == 1)
            writeComparison(xml, {report.comparisons.front(), report.runs, report.title, report.facts});
        else
            for (std::size_t i = 0; i < report.comparisons.size(); ++i)
                writeCandidate(xml, report, i);
        writeFacts(xml, report);
    }
    xml.writeEndElement();
    xml.writeEndDocument();
    return bytes + '\n';
}

} // namespace usar::campaign
