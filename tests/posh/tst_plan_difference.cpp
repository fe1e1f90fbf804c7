#include <QTest>

#include <algorithm>

#include "core/base/random.h"
#include "core/posh/edit/plan_difference.h"
#include "core/posh/edit/plan_edits.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/model/plan_walk.h"
#include "random_plan.h"
#include "tests/suite/suite.h"

namespace tst_plan_difference {

using namespace usar;
using namespace usar::posh;

namespace {

const std::string source = R"((
  (C pick (goal ((holding)))
    (elements
      ((grab (trigger ((near))) close 3))
      ((look (trigger ((lost))) turn))
      ((go   drive))))
  (AP wave (up down up))
  (AD rest ((goal ((rested))) (sleep)))
  (DC me
    (drives
      ((safe (trigger ((bumped))) wave (seconds 2)))
      ((work pick)))))
)";

std::string with(std::string text, const std::string& old, const std::string& wanted) {
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + wanted.size()))
        text.replace(at, old.size(), wanted);
    return text;
}

QString linesOf(const std::vector<PlanChange>& changes) {
    QStringList lines;
    for (const PlanChange& change : changes)
        lines << QString::fromStdString(change.line);
    return lines.join('\n');
}

/// Without comments of lines, and with the forms in the order of their names.
Plan bare(Plan plan) {
    forEachRemarks(plan, [](Remarks& remarks) { remarks = {}; });
    plan.closing_remarks.clear();
    std::stable_sort(plan.forms.begin(), plan.forms.end(),
                     [](const Form& a, const Form& b) { return nameOf(a).text < nameOf(b).text; });
    return plan;
}

Result<PlanEdit> anyEdit(const std::string& text, Random& random) {
    const Plan plan = readPlan(text).plan;
    const std::vector<NamedPart> parts = partsOf(plan);
    const PlanPart part = parts[random() % parts.size()].part;
    switch (random() % 6) {
    case 0:
        return removePart(text, part);
    case 1:
        return duplicatePart(text, part);
    case 2:
        return shiftPart(text, part, random() % 2 == 0 ? 1 : -1);
    case 3:
        return renamePart(text, part, "quite-fresh");
    case 4:
        return joinLevel(text, part, -1);
    default:
        return setSenses(text, part, {SenseTest{Call{{"asked", {}}, {}}, std::nullopt, std::nullopt}});
    }
}

} // namespace

class tst_PlanDifference : public QObject {
    Q_OBJECT
private slots:
    void changesAreToldInALineEach_data();
    void changesAreToldInALineEach();
    void placesAreThoseOfBothTexts();
    void layoutIsNoDifference();
    void noPlanDiffersFromItself();
    void everyEditIsTold();
};

void tst_PlanDifference::changesAreToldInALineEach_data() {
    QTest::addColumn<QString>("after");
    QTest::addColumn<QString>("lines");
    const auto row = [](const char* name, const std::string& after, const char* lines) {
        QTest::newRow(name) << QString::fromStdString(after) << QString::fromUtf8(lines);
    };
    row("nothing", source, "");
    row("trigger", with(source, "((near))", "((near 2 <))"),
        "element \"grab\" of \"pick\": trigger was ((near)), is ((near 2 <))");
    row("trigger taken away", with(source, "(trigger ((lost))) ", ""),
        "element \"look\" of \"pick\": trigger was ((lost)), is none");
    row("act and frequency", with(source, "wave (seconds 2)", "hop"),
        "drive \"safe\": act was wave, is hop\ndrive \"safe\": frequency was (seconds 2), is none");
    row("starts", with(source, "close 3", "close 4"), "element \"grab\" of \"pick\": starts was 3, is 4");
    row("goal", with(source, "holding", "held"), "competence \"pick\": goal was ((holding)), is ((held))");
    row("kind of the collection", with(source, "(DC", "(RDC"), "collection \"me\": kind was DC, is RDC");
    row("form renamed, with its calls", with(source, "wave", "greet"), "pattern \"wave\" renamed to \"greet\"");
    row("element renamed", with(source, "(look", "(search"), "element \"look\" of \"pick\" renamed to \"search\"");
    row("element added", with(source, "((go ", "((new x))\n((go "), "element \"new\" of \"pick\" added");
    row("element removed", with(source, "((look (trigger ((lost))) turn))", ""),
        "element \"look\" of \"pick\" removed");
    row("form added", with(source, "(AP wave", "(AP hop (jump)) (AP wave"), "pattern \"hop\" added");
    row("form removed", with(source, "(AD rest ((goal ((rested))) (sleep)))", ""), "adopt \"rest\" removed");
    row("adopted", with(source, "sleep", "doze"), "adopt \"rest\": act was sleep, is doze");
    row("elements in another order", with(with(source, "((go   drive))", ""), "((grab", "((go   drive)) ((grab"),
        "element \"go\" of \"pick\" moved from place 3 to place 1");
    row("a step moved", with(source, "up down up", "up up down"),
        "pattern \"wave\": step up moved from place 3 to place 2");
    row("steps", with(source, "up down up", "up left up"),
        "pattern \"wave\": step left added\npattern \"wave\": step down removed");
    row("an element among the drives",
        with(with(source, "((look (trigger ((lost))) turn))", ""), "((work", "((look (trigger ((lost))) turn)) ((work"),
        "drive \"look\" moved from \"pick\" to \"me\"");
    row("an equal is added", with(source, "((work pick))", "((work pick) (play wave))"), "drive \"play\" added");
    row("two become equals", with(source, "wave (seconds 2)))\n      ((work", "wave (seconds 2))\n      (work"),
        "drive \"work\" is an equal of \"safe\" now");
    row("a comment of an element", with(source, "close 3", "close 3 \"quick\""),
        "element \"grab\" of \"pick\": comment was none, is \"quick\"");
    row("a comment of a form", with(source, "up down up)", "up down up) \"hello\""),
        "pattern \"wave\": comment was none, is \"hello\"");
    row("a time of a pattern", with(source, "(AP wave", "(AP wave (seconds 3)"),
        "pattern \"wave\": time was none, is (seconds 3)");
    row("a time of a competence", with(source, "(C pick", "(C pick (minutes 1)"),
        "competence \"pick\": time was none, is (minutes 1)");
    row("parameters", with(source, "(AD rest", "(AD rest vars($x=1)"),
        "adopt \"rest\": parameters was none, is vars($x=1)");
    row("arguments", with(source, "drive))", "drive(2)))"), "element \"go\" of \"pick\": act was drive, is drive(2)");
    row("a goal taken away", with(source, " (goal ((holding)))", ""),
        "competence \"pick\": goal was ((holding)), is none");
    row("a goal of the collection", with(source, "(DC me", "(DC me (goal ((done)))"),
        "collection \"me\": goal was none, is ((done))");
    row("collection renamed", with(source, "(DC me", "(DC you"), "collection \"me\" renamed to \"you\"");
    row("drive renamed", with(source, "(safe", "(rescue"), "drive \"safe\" renamed to \"rescue\"");
    row("a keyword in small letters", with(source, "(DC", "(dc"), "");
    row("a sense as a step", with(source, "up down up", "up (near) up"),
        "pattern \"wave\": step (near) added\npattern \"wave\": step down removed");
    row("documentation", with(source, "(C pick", "(documentation \"a\" \"b\" \"c\") (C pick"), "documentation added");
}

void tst_PlanDifference::changesAreToldInALineEach() {
    QFETCH(QString, after);
    QFETCH(QString, lines);
    const PlanReading reading = readPlan(after.toStdString());
    QVERIFY2(!hasErrors(reading.findings), reading.findings.empty() ? "" : toText(reading.findings.front()).c_str());
    QCOMPARE(linesOf(planDifference(readPlan(source).plan, reading.plan)), lines);
}

void tst_PlanDifference::placesAreThoseOfBothTexts() {
    const std::string after = with(source, "((go ", "((new x))\n((go ");
    const auto changes = planDifference(readPlan(source).plan, readPlan(after).plan);
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes[0].after_at.line, 6U);
    QCOMPARE(changes[0].after, std::optional(memberPart(0, 2, 0)));
    QCOMPARE(summaryOf(changes), std::string("1 added"));
    QCOMPARE(summaryOf({}), std::string("no difference"));
}

void tst_PlanDifference::layoutIsNoDifference() {
    const Plan plan = readPlan(source).plan;
    QVERIFY(planDifference(plan, readPlan("; said\n" + writePlan(plan)).plan).empty());
}

void tst_PlanDifference::noPlanDiffersFromItself() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        Random random = seeded(seed, 7);
        const Plan plan = readPlan(writePlan(doubles::randomPlan(random, options))).plan;
        const Plan other = readPlan(writePlan(doubles::randomPlan(random, options))).plan;
        QCOMPARE(linesOf(planDifference(plan, plan)), QString());
        planDifference(plan, other); // whatever it says, it says it
    }
}

void tst_PlanDifference::everyEditIsTold() {
    doubles::RandomPlanOptions options;
    options.with_decoration = true;
    int told = 0;
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        Random random = seeded(seed, 8);
        const std::string text = writePlan(doubles::randomPlan(random, options));
        const auto edited = anyEdit(text, random);
        if (!edited)
            continue;
        const Plan before = readPlan(text).plan;
        const Plan after = readPlan(edited->text).plan;
        const bool is_told = !planDifference(before, after).empty();
        if (is_told != (bare(before) != bare(after)))
            QFAIL((std::to_string(seed) + ":\n" + text + "\nbecame\n" + edited->text).c_str());
        told += is_told ? 1 : 0;
    }
    QVERIFY2(told > 500, qPrintable(QString::number(told)));
}

USAR_TEST(tst_PlanDifference)

} // namespace tst_plan_difference

#include "tst_plan_difference.moc"
