// Action patterns: steps in order, held against their siblings, given up at their limit.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_patterns {

using namespace usar::posh;

class tst_Patterns : public QObject {
    Q_OBJECT
private slots:
    void aPatternRestartsAfterAnInterruption();
    void aPatternInsideACompetenceIsNotReexamined();
    void aTimedPatternFailsAtItsLimit_data();
    void aTimedPatternFailsAtItsLimit();
    void eachStepTakesItsCycle();
    void instantStepsShareACycle();
    void aSenseStepGuardsTheRest();
    void aPatternOfSensesAloneSucceedsWithoutAnAct();
    void aFailedStepFailsThemAll();
    void patternsNest();
};

void tst_Patterns::aPatternRestartsAfterAnInterruption() {
    Trial trial("((AP p (one two)) (DC d (drives ((high (trigger ((danger))) dodge)) ((low p)))))");
    QVERIFY(trial.cycle(0).contains("init one"));
    trial.host.setResult("two", running);
    QVERIFY(trial.cycle(1).contains("init two"));
    trial.host.setSense("danger", true);
    QVERIFY(trial.cycle(2).contains("done two interrupted; interrupt low; start high"));
    trial.host.setSense("danger", false);
    QVERIFY(trial.cycle(3).contains("start low; init one"));
}

void tst_Patterns::aPatternInsideACompetenceIsNotReexamined() {
    Trial trial("((C c (elements ((e (trigger ((on))) p)))) (AP p (one two)) (DC d (drives ((work c)))))");
    trial.host.setSense("on", true);
    trial.cycle(0);
    trial.host.setSense("on", false);
    QCOMPARE(trial.cycle(1), "init two; run two -> RunningOnce; done two finished; succeeded work; end Fired");
}

void tst_Patterns::aTimedPatternFailsAtItsLimit_data() {
    QTest::addColumn<QByteArray>("limit");
    QTest::addColumn<int>("times_out_in"); // of ten cycles that are 200 ms apart; -1: in none
    QTest::newRow("between two cycles") << QByteArray("(seconds 0.5)") << 3;
    QTest::newRow("on a cycle") << QByteArray("(seconds 0.6)") << 3;
    QTest::newRow("milliseconds") << QByteArray("(none 1000)") << 5;
    QTest::newRow("none") << QByteArray("(none 0)") << -1;
    QTest::newRow("nil") << QByteArray("nil") << -1;
}

void tst_Patterns::aTimedPatternFailsAtItsLimit() {
    QFETCH(QByteArray, limit);
    QFETCH(int, times_out_in);
    Trial trial("((AP p " + limit.toStdString() + " (walk)) (DC d (drives ((work p)))))");
    trial.host.setResult("walk", running);
    int timed_out = -1;
    for (int cycle = 0; cycle < 10 && timed_out < 0; ++cycle)
        if (trial.cycle(200 * cycle) == "timeout p; done walk interrupted; failed work; end NoAction")
            timed_out = cycle;
    QCOMPARE(timed_out, times_out_in);
}

void tst_Patterns::eachStepTakesItsCycle() {
    Trial trial("((AP p (one two)) (DC d (drives ((work p)))))");
    QCOMPARE(trial.cycle(0), "start work; init one; run one -> RunningOnce; done one finished; end Fired");
    QCOMPARE(trial.cycle(1), "init two; run two -> RunningOnce; done two finished; succeeded work; end Fired");
}

void tst_Patterns::instantStepsShareACycle() {
    Trial trial("((AP p (one two)) (DC d (drives ((work p)))))");
    trial.host.setResult("one", ActResult::Finished);
    QCOMPARE(trial.cycle(0), "start work; init one; run one -> Finished; done one finished; init two; run two -> "
                             "RunningOnce; done two finished; succeeded work; end Fired");
}

void tst_Patterns::aSenseStepGuardsTheRest() {
    Trial trial("((AP p (one (clear) two)) (DC d (drives ((work p)))))");
    trial.cycle(0);
    QCOMPARE(trial.cycle(1), "sense clear -> nil F; failed work; end NoAction");
    trial.cycle(2);
    trial.host.setSense("clear", true);
    QVERIFY(trial.cycle(3).startsWith("sense clear -> true T; init two"));
}

void tst_Patterns::aPatternOfSensesAloneSucceedsWithoutAnAct() {
    Trial trial("((AP p ((x) (x))) (DC d (drives ((work p)))))");
    trial.host.setSense("x", true);
    QCOMPARE(trial.cycle(0), "start work; sense x -> true T; sense x -> true T cached; succeeded work; end NoAction");
}

void tst_Patterns::aFailedStepFailsThemAll() {
    Trial trial("((AP outer (inner last)) (AP inner (one)) (DC d (drives ((work outer)))))");
    trial.host.setResult("one", ActResult::Failed);
    QVERIFY(trial.cycle(0).endsWith("done one failed; failed work; end Fired"));
}

void tst_Patterns::patternsNest() {
    Trial trial("((AP outer (inner last)) (AP inner (one)) (DC d (drives ((work outer)))))");
    trial.cycle(0);
    QVERIFY(trial.cycle(1).contains("init last"));
}

USAR_TEST(tst_Patterns)

} // namespace tst_patterns

#include "tst_patterns.moc"
