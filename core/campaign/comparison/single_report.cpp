#include "core/campaign/comparison/single_report.h"

#include <algorithm>
#include <set>

#include <QJsonArray>

#include "core/campaign/comparison/html_parts.h"

namespace usar::campaign {

namespace {

/// The middle of a figure, and the middle half of its runs.
struct SingleFigure {
    Metric metric;
    std::vector<double> sorted;

    double at(double share) const { return quantileOfSorted(sorted, share); }
    QString words(double share) const { return amount(at(share), metric); }
};

std::vector<SingleFigure> figuresIn(const std::vector<RunFigures>& runs) {
    std::vector<SingleFigure> figures;
    for (const Metric& metric : usualMetrics()) {
        SingleFigure figure{metric, {}};
        for (const RunFigures& run : runs)
            if (const auto value = valueOf(run, metric))
                figure.sorted.push_back(*value);
        std::ranges::sort(figure.sorted);
        if (!figure.sorted.empty())
            figures.push_back(std::move(figure));
    }
    return figures;
}

/// Counts the runs that were done, among those that say something of the variant.
Count doneOf(const std::vector<RunFigures>& runs) {
    Count count;
    for (const RunFigures& run : runs) {
        count.trials += counts(run.outcome) ? 1 : 0;
        count.successes += run.outcome == Outcome::Done ? 1 : 0;
    }
    return count;
}

QString noteOf(const SingleReport& report) {
    return "The campaign has one variant, " + nameOf(report.runs.front().variant) +
           ", so there is nothing to compare it with.";
}

/// Says how many runs do not count, and why; empty if all do.
QString notCounted(const SingleReport& report) {
    const std::size_t left_out = report.runs.size() - doneOf(report.runs).trials;
    return left_out == 0 ? QString()
                         : QString("%1 of %2 runs do not count, because they were refused or killed.")
                               .arg(left_out)
                               .arg(report.runs.size());
}

QString successOf(const SingleReport& report) {
    const Count count = doneOf(report.runs);
    const Interval interval = wilsonInterval(count);
    return QString("%1 (95 %: %2 to %3 %)").arg(amount(count), percent(interval.low), percent(interval.high));
}

void writeFigures(QXmlStreamWriter& xml, const SingleReport& report) {
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Figures");
    {
        const HtmlElement table(xml, "table");
        writeHead(xml, {"", "Median", "Middle half", "Runs"});
        const HtmlElement body(xml, "tbody");
        for (const SingleFigure& figure : figuresIn(report.runs)) {
            const HtmlElement row(xml, "tr");
            write(xml, "th", QString::fromStdString(figure.metric.title));
            write(xml, "td", figure.words(0.5), "figure");
            write(xml, "td", figure.words(0.25) + " to " + figure.words(0.75), "figure");
            write(xml, "td", QString::number(figure.sorted.size()), "figure");
        }
    }
    write(xml, "p",
          "A run that was not done counts its time limit as its duration; its way, mapping error and charges are left "
          "out.",
          "note");
}

/// Returns the runs that count, of all missions or of the one whose name is given.
VariantRuns countingRuns(const SingleReport& report, const std::optional<std::string>& mission = {}) {
    VariantRuns all{nameOf(report.runs.front().variant), {}};
    for (const RunFigures& run : report.runs)
        if (counts(run.outcome) && (!mission || run.mission == *mission))
            all.runs.push_back(&run);
    return all;
}

void writeBody(QXmlStreamWriter& xml, const SingleReport& report) {
    const QString variant = nameOf(report.runs.front().variant);
    {
        const HtmlElement header(xml, "header");
        write(xml, "p", nameOf(report.title), "eyebrow");
        write(xml, "h1", QString("%1: %2 done.").arg(variant, amount(doneOf(report.runs))));
        write(xml, "p", noteOf(report), "lead");
        write(xml, "p", "Done: " + successOf(report) + ". " + notCounted(report), "note");
    }
    writeFigures(xml, report);
    writeProfile(xml, countingRuns(report), {});
    std::set<std::string> missions;
    for (const RunFigures& run : report.runs)
        missions.insert(run.mission);
    for (const std::string& mission : missions)
        writeCourse(xml, nameOf(mission), countingRuns(report, mission), {});
    {
        const HtmlElement section(xml, "section");
        write(xml, "h2", "Runs to look at");
        writeRuns(xml, "The worst of all", worstOf(countingRuns(report).runs, most_worst_runs));
    }
    writeFailures(xml, failureGroups(report.runs.front().variant, {}, report.runs), {variant});
    writeFacts(xml, report.facts);
}

} // namespace

QString textReport(const SingleReport& report) {
    QString text = noteOf(report) + "\n\nDone: " + successOf(report) + ".\n";
    for (const SingleFigure& figure : figuresIn(report.runs))
        text += QString("%1: median %2, middle half %3 to %4, %5 runs.\n")
                    .arg(QString::fromStdString(figure.metric.title), figure.words(0.5), figure.words(0.25),
                         figure.words(0.75))
                    .arg(figure.sorted.size());
    const QString left_out = notCounted(report);
    return left_out.isEmpty() ? text : text + left_out + '\n';
}

QByteArray htmlReport(const SingleReport& report) {
    return pageOf(nameOf(report.title), [&](QXmlStreamWriter& xml) { writeBody(xml, report); });
}

QJsonObject jsonReport(const SingleReport& report) {
    const Count done = doneOf(report.runs);
    QJsonArray metrics;
    for (const SingleFigure& figure : figuresIn(report.runs))
        metrics.append(QJsonObject{{"key", QString::fromStdString(figure.metric.key)},
                                   {"unit", QString::fromStdString(figure.metric.unit)},
                                   {"runs", static_cast<qint64>(figure.sorted.size())},
                                   {"quarter", figure.at(0.25)},
                                   {"median", figure.at(0.5)},
                                   {"three_quarters", figure.at(0.75)}});
    QJsonObject facts;
    for (const auto& [name, value] : report.facts)
        facts[QString::fromStdString(name)] = QString::fromStdString(value);
    return {{"title", QString::fromStdString(report.title)},
            {"variant", QString::fromStdString(report.runs.front().variant)},
            {"exit_code", 0},
            {"runs", static_cast<qint64>(done.trials)},
            {"done", static_cast<qint64>(done.successes)},
            {"note", noteOf(report)},
            {"metrics", metrics},
            {"facts", facts}};
}

} // namespace usar::campaign
