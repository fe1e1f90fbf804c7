#include <QTest>

#include <algorithm>

#include "core/posh/language/plan_reader.h"
#include "core/posh/model/plan_walk.h"
#include "plan_corpus.h"
#include "tests/suite/suite.h"

namespace tst_plan_corpus {

using namespace usar;
using namespace usar::posh;

namespace {

int countOf(const Findings& findings, std::initializer_list<Code> codes) {
    return static_cast<int>(std::count_if(findings.begin(), findings.end(), [&](const Finding& finding) {
        return std::find(codes.begin(), codes.end(), finding.code) != codes.end();
    }));
}

template <class Levels>
int membersOf(const Levels& levels) {
    int members = 0;
    for (const auto& level : levels)
        members += static_cast<int>(level.size());
    return members;
}

std::map<std::string, int> countsOf(const PlanReading& reading) {
    std::map<std::string, int> counts{{"levels", 0}, {"drives", 0}, {"C", 0},     {"elements", 0},
                                      {"AP", 0},     {"AD", 0},     {"senses", 0}};
    for (const Form& form : reading.plan.forms) {
        if (const auto* const collection = std::get_if<Collection>(&form)) {
            counts["levels"] = static_cast<int>(collection->levels.size());
            counts["drives"] = membersOf(collection->levels);
        } else if (const auto* const competence = std::get_if<Competence>(&form)) {
            ++counts["C"];
            counts["elements"] += membersOf(competence->levels);
        } else {
            ++counts[std::holds_alternative<Pattern>(form) ? "AP" : "AD"];
        }
        forEachCall(form, [&](const Call&, bool is_sense) { counts["senses"] += is_sense ? 1 : 0; });
    }
    counts["dup-warnings"] = countOf(reading.findings, {Code::DuplicateDrive, Code::DuplicateElement});
    counts["unused"] = countOf(reading.findings, {Code::NeverUsed});
    return counts;
}

const Finding* firstError(const Findings& findings) {
    const auto error = std::find_if(findings.begin(), findings.end(),
                                    [](const Finding& finding) { return severityOf(finding.code) == Severity::Error; });
    return error == findings.end() ? nullptr : &*error;
}

void addRows(bool with_error) {
    QTest::addColumn<corpus::PlanFile>("file");
    int number = 0;
    for (const corpus::PlanFile& file : corpus::planFiles())
        if (file.error.has_value() == with_error)
            QTest::addRow("%d %s", ++number, file.name.c_str()) << file;
}

} // namespace

class tst_PlanCorpus : public QObject {
    Q_OBJECT
private slots:
    void soundPlansReadWithTheirCounts_data() { addRows(false); }
    void soundPlansReadWithTheirCounts();
    void theFirstErrorIsTheExpectedOne_data() { addRows(true); }
    void theFirstErrorIsTheExpectedOne();
    void everyErrorSaysTheFix_data() { addRows(true); }
    void everyErrorSaysTheFix();
};

void tst_PlanCorpus::soundPlansReadWithTheirCounts() {
    QFETCH(corpus::PlanFile, file);
    const PlanReading reading = readPlan(file.text);
    const Finding* const error = firstError(reading.findings);
    QVERIFY2(!error, error ? toText(*error).c_str() : "");
    const auto counts = countsOf(reading);
    for (const auto& [what, expected] : file.counts)
        QVERIFY2(counts.contains(what) && counts.at(what) == expected,
                 qPrintable(QString("%1: %2").arg(what.c_str()).arg(counts.contains(what) ? counts.at(what) : -1)));
}

void tst_PlanCorpus::theFirstErrorIsTheExpectedOne() {
    QFETCH(corpus::PlanFile, file);
    const PlanReading reading = readPlan(file.text);
    const Finding* const error = firstError(reading.findings);
    QVERIFY2(error, "read without an error");
    QCOMPARE(QString::fromStdString(toText(error->code)), QString::fromStdString(file.error->code));
    QVERIFY2(error->at.line == file.error->line && error->at.column == file.error->column, toText(*error).c_str());
}

void tst_PlanCorpus::everyErrorSaysTheFix() {
    QFETCH(corpus::PlanFile, file);
    for (const Finding& finding : readPlan(file.text).findings)
        QVERIFY2(finding.message.find("; ") != std::string::npos, toText(finding).c_str());
}

USAR_TEST(tst_PlanCorpus)

} // namespace tst_plan_corpus

#include "tst_plan_corpus.moc"
