#include "core/campaign/comparison/html_parts.h"

#include <algorithm>

#include "core/campaign/comparison/coverage_band.h"
#include "core/campaign/comparison/svg_plots.h"

namespace usar::campaign {

extern const char comparison_style[]; // resources/reports/comparison.css

namespace {

constexpr std::size_t groups_shown = 12, places_shown = 5;

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
    write(xml, "td", nameOf(run.mission) + ", seed " + QString::number(run.seed));
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

ProfileCurve curveOf(const VariantRuns& variant) {
    ProfileCurve curve{variant.name, {}};
    for (const RunFigures* run : variant.runs)
        if (run->outcome == Outcome::Done)
            if (const auto found = run->metrics.find("duration_s"); found != run->metrics.end() && found->second)
                curve.sorted.push_back(*found->second);
    std::ranges::sort(curve.sorted);
    return curve;
}

/// How many runs of each variant it has; of a single variant one number.
template <class Counted>
QStringList countsOf(const Counted& counted, const QStringList& variants) {
    QStringList counts{QString::number(counted.of_baseline)};
    if (variants.size() > 1)
        counts << QString::number(counted.of_candidate);
    return counts;
}

void writeFailureRow(QXmlStreamWriter& xml, const QStringList& words, const QStringList& counts,
                     const QString& style_class = {}) {
    const HtmlElement row(xml, "tr", style_class);
    for (const QString& text : words)
        write(xml, "td", text);
    for (const QString& count : counts)
        write(xml, "td", count, "figure");
}

/// A row for each of the places at which most runs of the group ended, if any place is known.
void writeFailurePlaces(QXmlStreamWriter& xml, const FailureGroup& group, const QStringList& variants) {
    if (!group.places.front().place)
        return;
    FailurePlace others;
    for (std::size_t i = 0; i < group.places.size(); ++i) {
        const FailurePlace& one = group.places[i];
        if (one.place && i < places_shown) {
            writeFailureRow(xml, {QString(), QString::fromStdString(wordsOf(one.place))}, countsOf(one, variants),
                            "place");
            continue;
        }
        others.of_baseline += one.of_baseline;
        others.of_candidate += one.of_candidate;
    }
    if (others.size() > 0)
        writeFailureRow(xml, {QString(), "elsewhere, or nobody knows where"}, countsOf(others, variants), "place");
}

/// The head of the page with its title and its style.
void writeHeadOfPage(QXmlStreamWriter& xml, const QString& title) {
    const HtmlElement head(xml, "head");
    xml.writeEmptyElement("meta");
    xml.writeAttribute("charset", "utf-8");
    xml.writeEmptyElement("meta");
    xml.writeAttribute("name", "viewport");
    xml.writeAttribute("content", "width=device-width, initial-scale=1");
    xml.writeEmptyElement("meta");
    xml.writeAttribute("name", "color-scheme");
    xml.writeAttribute("content", "light dark");
    write(xml, "title", title);
    // The style sheet has none of the characters that XML escapes, because HTML would not take them back there.
    write(xml, "style", comparison_style);
}

} // namespace

void writeWith(QXmlStreamWriter& xml, const QString& name, const QXmlStreamAttribute& attribute, const QString& words) {
    xml.writeStartElement(name);
    xml.writeAttribute(attribute);
    xml.writeCharacters(words);
    xml.writeEndElement();
}

void writeCut(QXmlStreamWriter& xml, std::size_t shown, std::size_t all) {
    if (shown < all)
        write(xml, "p", QString("%1 of %2 are shown.").arg(shown).arg(all), "note");
}

void writeProfile(QXmlStreamWriter& xml, const VariantRuns& baseline, const VariantRuns& candidate) {
    const ProfileCurve before = curveOf(baseline), after = curveOf(candidate);
    if (before.sorted.empty() && after.sorted.empty())
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Share of the seeds that are done by each time");
    drawProfile(xml, before, after, baseline.runs.size(), usualMetrics().front());
}

void writeCourse(QXmlStreamWriter& xml, const QString& mission, const VariantRuns& baseline,
                 const VariantRuns& candidate) {
    writeCoverage(xml, mission, baseline, candidate);
    writePlaces(xml, mission, baseline, candidate);
}

void writeRuns(QXmlStreamWriter& xml, const QString& title, const std::vector<const RunFigures*>& runs) {
    const HtmlElement table(xml, "table", "runs");
    write(xml, "caption", title);
    writeHead(xml, {"Run", "Variant", "Mission and seed", "Outcome", "Why, and how to fly it again", ""});
    const HtmlElement body(xml, "tbody");
    for (const RunFigures* run : runs)
        writeRun(xml, *run);
}

void writeFailures(QXmlStreamWriter& xml, const std::vector<FailureGroup>& groups, const QStringList& variants) {
    const HtmlElement section(xml, "section");
    write(xml, "h2", "Why runs were not done");
    if (groups.empty()) {
        write(xml, "p", "All runs were done.");
        return;
    }
    const std::size_t shown = std::min(groups.size(), groups_shown);
    {
        const HtmlElement table(xml, "table", "failures");
        writeHead(xml, QStringList{"Outcome", "Reason"} + variants);
        const HtmlElement body(xml, "tbody");
        for (std::size_t i = 0; i < shown; ++i) {
            const QString reason = printable(groups[i].reason);
            writeFailureRow(xml, {wordOf(groups[i].outcome), reason.isEmpty() ? "no reason is known" : reason},
                            countsOf(groups[i], variants));
            writeFailurePlaces(xml, groups[i], variants);
        }
    }
    writeCut(xml, shown, groups.size());
}

void writeFacts(QXmlStreamWriter& xml, const ReportFacts& facts) {
    if (facts.empty())
        return;
    const HtmlElement section(xml, "section");
    write(xml, "h2", "How this was made");
    const HtmlElement table(xml, "table", "facts");
    const HtmlElement body(xml, "tbody");
    for (const auto& [name, value] : facts) {
        const HtmlElement row(xml, "tr");
        write(xml, "th", printable(name));
        write(xml, "td", printable(value));
    }
}

QByteArray pageOf(const QString& title, const std::function<void(QXmlStreamWriter&)>& write_main) {
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.writeDTD("<!DOCTYPE html>\n");
    xml.writeStartElement("html");
    xml.writeAttribute("lang", "en");
    writeHeadOfPage(xml, title);
    {
        const HtmlElement body(xml, "body");
        const HtmlElement main(xml, "main");
        write_main(xml);
    }
    xml.writeEndElement();
    xml.writeEndDocument();
    return bytes + '\n';
}

} // namespace usar::campaign
