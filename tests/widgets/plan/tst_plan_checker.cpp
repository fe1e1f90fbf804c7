// What the plan editor knows of a text: its findings alone and for a robot, and the fixes for them.
#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_editor_samples.h"
#include "widgets/models/plan/plan_checker.h"

namespace tst_plan_checker {

using namespace usar;
using namespace usar::widgets;

namespace {

/// The courier's plan with an act that the robot does not have.
std::string brokenPlan() {
    std::string text(courier_plan);
    return text.replace(text.find("Brake"), 5, "Broke");
}

} // namespace

class tst_PlanChecker : public QObject {
    Q_OBJECT
private slots:
    void runnable_data();
    void runnable();
    void aTextIsCheckedOnceUntilItChanges();
    void anotherRobotMakesItCheckAgain();
    void fixesFitTheRobot();
};

void tst_PlanChecker::runnable_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("with_robot");
    QTest::addColumn<bool>("runnable");
    const QByteArray courier(courier_plan.data(), static_cast<qsizetype>(courier_plan.size()));
    QTest::newRow("sound, alone") << courier << false << true;
    QTest::newRow("sound, for its robot") << courier << true << true;
    QTest::newRow("unknown act, alone") << QByteArray::fromStdString(brokenPlan()) << false << true;
    QTest::newRow("unknown act, for a robot") << QByteArray::fromStdString(brokenPlan()) << true << false;
    QTest::newRow("missing parenthesis") << courier.trimmed().chopped(1) << true << false;
    QTest::newRow("no collection, alone") << QByteArray("((AP halt (Stop)))") << false << false;
}

void tst_PlanChecker::runnable() {
    QFETCH(QByteArray, text);
    QFETCH(bool, with_robot);
    QFETCH(bool, runnable);
    PlanChecker checker;
    if (with_robot)
        checker.setPrimitives(courierPrimitives());
    QCOMPARE(checker.binds(), with_robot);
    checker.check(text.toStdString());
    QCOMPARE(checker.isRunnable(), runnable);
}

void tst_PlanChecker::aTextIsCheckedOnceUntilItChanges() {
    PlanChecker checker;
    QVERIFY(!checker.isCurrent());
    checker.check(courier_plan);
    QVERIFY(checker.isCurrent() && !posh::hasErrors(checker.findings()));
    checker.check("(");
    QVERIFY(!posh::hasErrors(checker.findings())); // the caller has not said that the text changed
    checker.invalidate();
    checker.check("(");
    QVERIFY(checker.isCurrent() && posh::hasErrors(checker.findings()));
}

void tst_PlanChecker::anotherRobotMakesItCheckAgain() {
    PlanChecker checker;
    checker.check(brokenPlan());
    QVERIFY(!posh::hasErrors(checker.findings()));
    checker.setPrimitives(courierPrimitives());
    QVERIFY(!checker.isCurrent());
    checker.check(brokenPlan());
    QCOMPARE(checker.findings().back().code, posh::Code::UnknownPrimitive);
}

void tst_PlanChecker::fixesFitTheRobot() {
    PlanChecker checker;
    checker.setPrimitives(courierPrimitives());
    checker.check(brokenPlan());
    const auto fixes = checker.fixes(brokenPlan(), checker.findings().back());
    QVERIFY(!fixes.empty());
    QCOMPARE(fixes.front().title, std::string("Write Brake"));
    QCOMPARE(posh::withFix(brokenPlan(), fixes.front()), std::string(courier_plan));
}

USAR_TEST(tst_PlanChecker)

} // namespace tst_plan_checker

#include "tst_plan_checker.moc"
