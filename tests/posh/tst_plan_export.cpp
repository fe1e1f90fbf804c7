#include <QTest>

#include "core/posh/language/plan_export.h"
#include "core/posh/language/plan_reader.h"
#include "plan_corpus.h"
#include "random_plan.h"
#include "tests/suite/suite.h"

namespace tst_plan_export {

using namespace usar;
using namespace usar::posh;

namespace {

/// "1:2 what, 3:4 what", of the middle of each message.
QString lossesOf(const PlanExport& exported) {
    QStringList losses;
    for (const Loss& loss : exported.losses)
        losses << QString("%1:%2 %3")
                      .arg(loss.at.line)
                      .arg(loss.at.column)
                      .arg(QString::fromStdString(loss.message).section(" has no ", 1));
    return losses.join(", ");
}

/// An export is read without errors, and the dialect has all that is in it.
std::string complaintOn(const Plan& plan, Dialect dialect) {
    const PlanExport exported = exportPlan(plan, dialect);
    const PlanReading reading = readPlan(exported.text);
    for (const Finding& finding : reading.findings)
        if (severityOf(finding.code) == Severity::Error && finding.code != Code::DuplicateName)
            return toText(finding) + " in\n" + exported.text;
    const PlanExport again = exportPlan(reading.plan, dialect);
    return again.text == exported.text ? "" : "exported again it is\n" + again.text + "instead of\n" + exported.text;
}

} // namespace

class tst_PlanExport : public QObject {
    Q_OBJECT
private slots:
    void eachLossIsTold_data();
    void eachLossIsTold();
    void aCollectionIsExported();
    void exportsAreReadAndLoseNothingMore_data();
    void exportsAreReadAndLoseNothingMore();
    void randomPlansAreExported();
};

void tst_PlanExport::eachLossIsTold_data() {
    QTest::addColumn<Dialect>("dialect");
    QTest::addColumn<QString>("form");
    QTest::addColumn<QString>("exported");
    QTest::addColumn<QString>("losses");
    const auto row = [](const char* name, Dialect dialect, const char* form, const char* exported, const char* losses) {
        QTest::newRow(name) << dialect << QString(form) << QString(exported) << QString(losses);
    };
    const Dialect classic = Dialect::Classic;
    const Dialect yaposh = Dialect::Yaposh;
    row("a plain pattern", classic, "(AP p (minutes 2) (a (s 3 <)))", "(AP p (minutes 2) (a (s 3 <)))", "");
    row("parameters", classic, "(AP p vars($x=1) (a($x) b))", "(AP p (a b))",
        "2:12 parameters, which are left out, 2:21 arguments, which are left out");
    row("dots", classic, "(AP p (a.b.Act))", "(AP p (a_b_Act))", "2:8 name like \"a.b.Act\"; it becomes \"a_b_Act\"");
    row("truth", classic, "(AP p ((s true) (t false !=)))", "(AP p ((s 1) (t 0 !=)))",
        "2:11 value \"true\"; it becomes \"1\", 2:20 value \"false\"; it becomes \"0\"");
    row("a text", classic, "(AP p ((s \"far away\")))", "(AP p ((s 'far-away)))",
        "2:11 value \"\"far away\"\"; it becomes \"'far-away\"");
    row("a constant", classic, "(AP p ((s 'a.b.RED)))", "(AP p ((s 'RED)))",
        "2:11 value \"'a.b.RED\"; it becomes \"'RED\"");
    row("an adopt", classic, "(AD d ((goal ((s))) (act)))", "(C d (goal ((s)))\n    (elements\n      ((d act))))",
        "2:5 adopt; it becomes a competence, which loses its place when it is interrupted");
    row("a pattern within a pattern", classic, "(AP p (q a)) (AP q (a))", "(AP p (q a))\n  (AP q (a))",
        "2:8 step that is a pattern, an adopt or a competence before the last; it stays as it is");
    row("a comment's quotes", classic, "(AP p (a) \"say \\\"x;y\\\"\")", "(AP p (a) \"say 'x,y'\")",
        "2:11 line ends, quotes, backslashes, ; or # in texts; they are replaced");
    row("a digit", yaposh, "(AP p (3act))", "(AP p (_3act))", "2:8 name like \"3act\"; it becomes \"_3act\"");
    row("limits and goals", yaposh, "(C k (minutes 2) (goal ((s))) (elements ((e a 3))))",
        "(C k\n    (elements\n      ((e a 3))))",
        "2:7 time limits, and this one is left out, 2:26 goal of a competence, which is left out");
    row("equals", yaposh, "(C k (elements ((e (trigger ((s red))) a) (f b))))",
        "(C k\n    (elements\n      ( (e (trigger ((s 'red))) a)\n        (f b))))",
        "2:44 members of equal priority: they keep the order in which they are written");
    row("a constant with a hyphen", yaposh, "(AD d ((goal ((s a.b-c))) (act)))", "(AD d ((goal ((s 'a.b_c))) (act)))",
        "2:18 value \"a.b-c\"; it becomes \"'a.b_c\"");
    row("senses as steps", yaposh, "(AP p ((s) a(1, $x=2)))", "(AP p (a(1, $x=2)))",
        "2:9 sense as a step; the step is left out");
    row("a digit in the classic dialect", classic, "(AP p (3act))", "(AP p (_3act))",
        "2:8 name like \"3act\"; it becomes \"_3act\"");
    row("a text that starts with a digit", classic, "(AP p ((s \"3 m\")))", "(AP p ((s '_3-m)))",
        "2:11 value \"\"3 m\"\"; it becomes \"'_3-m\"");
    row("nil", classic, "(AP p ((s nil)))", "(AP p ((s nil)))", "");
    row("a competence without elements", classic, "(C k (elements))", "(C k\n    (elements))",
        "2:4 competence without elements, and nothing was added");
    row("only senses as steps", yaposh, "(AP p ((s)))", "(AP p (doNothing))",
        "2:9 sense as a step; the step is left out");
    row("an adopt without a goal", yaposh, "(AD d ((goal nil) (act)))",
        "(AD d ((goal ((cz.cuni.amis.pogamut.sposh.executor.Fail))) (act)))", "");
    row("comments with #", yaposh, "# why\n(AP p (a)) # so", "; why\n  (AP p (a))  ; so", "");
}

void tst_PlanExport::eachLossIsTold() {
    QFETCH(Dialect, dialect);
    QFETCH(QString, form);
    QFETCH(QString, exported);
    QFETCH(QString, losses);
    const QString kind = dialect == Dialect::Classic ? "SDC" : "DC";
    const PlanReading reading = readPlan(("(\n" + form + "\n(DC life (drives ((x y)))))").toStdString());
    QVERIFY(!hasErrors(reading.findings));
    const PlanExport result = exportPlan(reading.plan, dialect);
    QCOMPARE(QString::fromStdString(result.text),
             "(\n  " + exported + "\n  (" + kind + " life\n    (drives\n      ((x y))))\n)\n");
    QCOMPARE(lossesOf(result), losses);
}

void tst_PlanExport::aCollectionIsExported() {
    const Plan plan = readPlan("((RDC d (drives ((a b (ticks 3))))))").plan;
    const PlanExport classic = exportPlan(plan, Dialect::Classic);
    QCOMPARE(classic.text, std::string("(\n  (SRDC d\n    (drives\n      ((a b))))\n)\n"));
    QCOMPARE(lossesOf(classic), QString("1:24 frequency in ticks, which is left out"));
    const PlanExport yaposh = exportPlan(plan, Dialect::Yaposh);
    QCOMPARE(yaposh.text, std::string("(\n  (RDC d\n    (drives\n      ((a b))))\n)\n"));
    QCOMPARE(lossesOf(yaposh), lossesOf(classic));
    const Plan fragment = readPlan("((AP p (a)))").plan;
    QCOMPARE(lossesOf(exportPlan(fragment, Dialect::Classic)), QString());
    QCOMPARE(lossesOf(exportPlan(fragment, Dialect::Yaposh)),
             QString("1:1 plan without a drive collection, and nothing was added"));
}

void tst_PlanExport::exportsAreReadAndLoseNothingMore_data() {
    QTest::addColumn<QByteArray>("text");
    int number = 0;
    for (const corpus::PlanFile& file : corpus::soundPlans())
        QTest::addRow("%d %s", ++number, file.name.c_str()) << QByteArray::fromStdString(file.text);
}

void tst_PlanExport::exportsAreReadAndLoseNothingMore() {
    QFETCH(QByteArray, text);
    const Plan plan = readPlan(text.toStdString()).plan;
    for (const Dialect dialect : {Dialect::Classic, Dialect::Yaposh}) {
        const std::string complaint = complaintOn(plan, dialect);
        QVERIFY2(complaint.empty(), complaint.c_str());
    }
}

void tst_PlanExport::randomPlansAreExported() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Random random = seeded(seed, 3);
        const Plan plan = doubles::randomPlan(random, options);
        for (const Dialect dialect : {Dialect::Classic, Dialect::Yaposh}) {
            const std::string complaint = complaintOn(plan, dialect);
            QVERIFY2(complaint.empty(), (std::to_string(seed) + ": " + complaint).c_str());
        }
    }
}

USAR_TEST(tst_PlanExport)

} // namespace tst_plan_export

#include "tst_plan_export.moc"
