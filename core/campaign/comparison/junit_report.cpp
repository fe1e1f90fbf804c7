#include "core/campaign/comparison/junit_report.h"

#include <QXmlStreamWriter>

#include "core/base/numbers.h"
#include "core/campaign/comparison/pairing.h"
#include "core/campaign/comparison/report.h"

namespace usar::campaign {

namespace {

/// The element that says how a run ended; empty for one that was done.
QString elementOf(Outcome outcome) {
    switch (outcome) {
    case Outcome::Done:
        return {};
    case Outcome::Failed:
        return "failure";
    case Outcome::Killed:
        return "skipped";
    case Outcome::Refused:
    case Outcome::Crashed:
    case Outcome::TimedOut:
    case Outcome::OutOfMemory:
        break;
    }
    return "error";
}

struct Totals {
    int tests = 0;
    std::map<QString, int> by_element;
    double time_s = 0.0;
};

double durationOf(const RunFigures& run) {
    const auto found = run.metrics.find("duration_s");
    return found == run.metrics.end() ? 0.0 : found->second.value_or(0.0);
}

Totals totalsOf(const std::vector<const RunFigures*>& runs) {
    Totals totals;
    for (const RunFigures* run : runs) {
        ++totals.tests;
        ++totals.by_element[elementOf(run->outcome)];
        totals.time_s += durationOf(*run);
    }
    return totals;
}

QString seconds(double time_s) {
    return QString::fromStdString(fixed(time_s, 3));
}

/// So many runs have this mission and seed; in several worlds there are several.
using SeedCounts = std::map<std::pair<std::string, std::uint64_t>, int>;

QString caseOf(const RunFigures& run, const SeedCounts& counts) {
    const QString seed = "seed " + QString::number(run.seed);
    return counts.at({run.mission, run.seed}) > 1 ? seed + ", pair " + QString::number(run.pair) : seed;
}

void writeCase(QXmlStreamWriter& xml, const RunFigures& run, const QString& name) {
    xml.writeStartElement("testcase");
    xml.writeAttribute("classname", nameOf(run.mission));
    xml.writeAttribute("name", name);
    xml.writeAttribute("time", seconds(durationOf(run)));
    if (const QString element = elementOf(run.outcome); !element.isEmpty()) {
        xml.writeStartElement(element);
        xml.writeAttribute("message", run.reason.empty() ? wordOf(run.outcome) : printable(run.reason));
        if (element != "skipped") // which has no type in JUnit's schema
            xml.writeAttribute("type", wordOf(run.outcome));
        xml.writeCharacters(printable(run.command));
        xml.writeEndElement();
    }
    xml.writeEndElement();
}

void writeSuite(QXmlStreamWriter& xml, const std::string& variant, const std::vector<const RunFigures*>& runs) {
    Totals totals = totalsOf(runs);
    xml.writeStartElement("testsuite");
    xml.writeAttribute("name", nameOf(variant));
    xml.writeAttribute("tests", QString::number(totals.tests));
    xml.writeAttribute("failures", QString::number(totals.by_element["failure"]));
    xml.writeAttribute("errors", QString::number(totals.by_element["error"]));
    xml.writeAttribute("skipped", QString::number(totals.by_element["skipped"]));
    xml.writeAttribute("time", seconds(totals.time_s));
    SeedCounts counts;
    for (const RunFigures* run : runs)
        ++counts[{run->mission, run->seed}];
    for (const RunFigures* run : runs)
        writeCase(xml, *run, caseOf(*run, counts));
    xml.writeEndElement();
}

} // namespace

QByteArray junitReport(const std::vector<RunFigures>& runs, const std::string& campaign) {
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
    xml.setAutoFormatting(true);
    xml.setAutoFormattingIndent(1);
    xml.writeStartDocument();
    xml.writeStartElement("testsuites");
    xml.writeAttribute("name", nameOf(campaign));
    for (const std::string& variant : variantsOf(runs)) {
        std::vector<const RunFigures*> own;
        for (const RunFigures& run : runs)
            if (run.variant == variant)
                own.push_back(&run);
        writeSuite(xml, variant, own);
    }
    xml.writeEndElement();
    xml.writeEndDocument();
    return bytes;
}

} // namespace usar::campaign
