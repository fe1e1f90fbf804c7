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

void writeCase(QXmlStreamWriter& xml, const RunFigures& run) {
    xml.writeStartElement("testcase");
    xml.writeAttribute("classname", nameOf(run.mission));
    xml.writeAttribute("name", "pair " + QString::number(run.pair));
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
    for (const RunFigures* run : runs)
        writeCase(xml, *run);
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
