// Competences: which element is chosen, goals, limits and retries.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_competences {

using namespace usar::posh;

class tst_Competences : public QObject {
    Q_OBJECT
private slots:
    void aCompetenceSucceedsWithItsElement();
    void aCompetenceWithoutReadyElementFails();
    void aSatisfiedGoalEndsACompetenceBeforeItActs();
    void retriesCountStartsNotCycles();
    void retriesOfANestedCompetenceCountStartsToo();
    void engagementsEndWhenACycleDoesNotVisit();
    void theFirstReadyElementIsChosenAnewInEachCycle();
    void equalElementsAreTakenInTheirOrder();
    void aRunningActThatNoElementWantsIsInterruptedInThatCycle();
    void anOuterGoalWinsOverAnInnerOne();
    void theLimitIsOfTheWholeEngagement();
    void retriesThatAreNoneAreUnlimited_data();
    void retriesThatAreNoneAreUnlimited();
};

void tst_Competences::aCompetenceSucceedsWithItsElement() {
    Trial trial("((C c (elements ((e walk)))) (DC d (drives ((work c)))))");
    QCOMPARE(trial.cycle(0),
             "start work; select e; init walk; run walk -> RunningOnce; done walk finished; succeeded work; end Fired");
}

void tst_Competences::aCompetenceWithoutReadyElementFails() {
    Trial trial("((C c (elements ((e (trigger ((on))) walk)))) (DC d (drives ((work c)) ((rest sit)))))");
    QCOMPARE(trial.cycle(0), "start work; sense on -> nil F; noelement c; failed work; end NoAction");
}

void tst_Competences::aSatisfiedGoalEndsACompetenceBeforeItActs() {
    Trial trial("((C c (goal ((there))) (elements ((e walk)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.host.setSense("there", true);
    QCOMPARE(trial.cycle(1), "sense there -> true T; goal c; done walk interrupted; succeeded work; end NoAction");
}

void tst_Competences::retriesCountStartsNotCycles() {
    Trial trial("((C c (elements ((e walk 2)) ((f sit)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    for (int cycle = 0; cycle < 5; ++cycle)
        QVERIFY(trial.cycle(cycle).contains("run walk -> Running"));
    trial.host.setResult("walk", failed);
    QVERIFY(trial.cycle(5).contains("done walk failed"));
    QVERIFY(trial.cycle(6).contains("init walk"));
    QVERIFY(trial.cycle(7).contains("skip retries; select f"));
}

void tst_Competences::retriesOfANestedCompetenceCountStartsToo() {
    Trial trial(
        "((C c (elements ((e inner 1)) ((f sit)))) (C inner (elements ((i walk)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    for (int cycle = 0; cycle < 5; ++cycle)
        QVERIFY(trial.cycle(cycle).contains("run walk -> Running"));
}

void tst_Competences::engagementsEndWhenACycleDoesNotVisit() {
    Trial trial(
        "((C c (elements ((e poke 1)) ((f sit)))) (DC d (drives ((other (trigger ((busy))) sing)) ((work c)))))");
    QVERIFY(trial.cycle(0).contains("select e"));
    QVERIFY(trial.cycle(1).contains("skip retries; select f"));
    trial.host.setSense("busy", true);
    trial.cycle(2);
    trial.host.setSense("busy", false);
    QVERIFY(trial.cycle(3).contains("select e"));
}

void tst_Competences::theFirstReadyElementIsChosenAnewInEachCycle() {
    Trial trial("((C c (elements ((up (trigger ((low))) climb)) ((on fly)))) (DC d (drives ((work c)))))");
    trial.host.setResult("fly", running);
    QVERIFY(trial.cycle(0).contains("select on; init fly"));
    trial.host.setSense("low", true);
    QCOMPARE(trial.cycle(1), "sense low -> true T; select up; done fly interrupted; init climb; run climb -> "
                             "RunningOnce; done climb finished; succeeded work; end Fired");
}

void tst_Competences::equalElementsAreTakenInTheirOrder() {
    Trial trial("((C c (elements ((a (trigger ((x))) one) (b two)))) (DC d (drives ((work c)))))");
    QVERIFY(trial.cycle(0).contains("select b"));
    trial.host.setSense("x", true);
    QVERIFY(trial.cycle(1).contains("select a"));
}

void tst_Competences::aRunningActThatNoElementWantsIsInterruptedInThatCycle() {
    Trial trial("((C c (elements ((e (trigger ((on))) walk)))) (DC d (drives ((work c)))))");
    trial.host.setSense("on", true);
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.host.setSense("on", false);
    QCOMPARE(trial.cycle(1), "sense on -> false F; noelement c; failed work; done walk interrupted; end NoAction");
}

void tst_Competences::anOuterGoalWinsOverAnInnerOne() {
    Trial trial("((C outer (goal ((home))) (elements ((o inner)))) (C inner (goal ((there))) (elements ((i p)))) "
                "(AP p (walk)) (DC d (drives ((work outer)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.host.setSense("home", true);
    trial.host.setSense("there", true);
    QCOMPARE(trial.cycle(1), "sense home -> true T; goal outer; done walk interrupted; succeeded work; end NoAction");
}

void tst_Competences::theLimitIsOfTheWholeEngagement() {
    Trial trial("((C c (seconds 1) (elements ((e one)))) (DC d (drives ((work c)))))");
    for (const int time_ms : {0, 400, 800})
        QVERIFY(trial.cycle(time_ms).contains("run one"));
    QCOMPARE(trial.cycle(1200), "start work; timeout c; failed work; end NoAction");
    QVERIFY(trial.cycle(1600).contains("run one"));
}

void tst_Competences::retriesThatAreNoneAreUnlimited_data() {
    QTest::addColumn<QByteArray>("retries");
    for (const char* const retries : {"", "nil", "0", "-1"})
        QTest::addRow("(%s)", retries) << QByteArray(retries);
}

void tst_Competences::retriesThatAreNoneAreUnlimited() {
    QFETCH(QByteArray, retries);
    Trial trial("((C c (elements ((e poke " + retries.toStdString() + ")))) (DC d (drives ((work c)))))");
    for (int cycle = 0; cycle < 10; ++cycle)
        QVERIFY(trial.cycle(cycle).contains("run poke"));
}

USAR_TEST(tst_Competences)

} // namespace tst_competences

#include "tst_competences.moc"
