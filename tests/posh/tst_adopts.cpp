// Adopts: they keep their place and try again.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_adopts {

using namespace usar::posh;

class tst_Adopts : public QObject {
    Q_OBJECT
private slots:
    void anAdoptTriesAgainAfterFailure();
    void anAdoptKeepsItsPlaceWhenInterrupted();
    void anAdoptWhoseGoalHoldsSucceedsAtOnce();
    void whatSucceedsIsDoneAgain();
    void theInnermostIsKept();
    void aSatisfiedGoalEndsARunningAct();
    void anInnerGoalLeavesTheAdoptForTheNextCycle();
};

void tst_Adopts::anAdoptTriesAgainAfterFailure() {
    Trial trial("((AD keep ((goal ((there))) (p))) (AP p (one two)) (DC d (drives ((work keep)))))");
    trial.host.setResult("two", failed);
    trial.cycle(0);
    QCOMPARE(trial.cycle(1),
             "sense there -> nil F; init two; run two -> Failed; done two failed; retry keep; end Fired");
    QVERIFY(trial.cycle(2).contains("init one"));
}

void tst_Adopts::anAdoptKeepsItsPlaceWhenInterrupted() {
    Trial trial("((AD keep ((goal ((there))) (walk))) (AP p (prep keep)) "
                "(DC d (drives ((high (trigger ((danger))) dodge)) ((low p)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    QVERIFY(trial.cycle(1).contains("init walk"));
    trial.host.setSense("danger", true);
    QVERIFY(trial.cycle(2).contains("done walk interrupted; interrupt low (adopt kept); start high"));
    trial.host.setSense("danger", false);
    QCOMPARE(trial.cycle(3),
             "sense danger -> false F; sense there -> nil F; init walk; run walk -> Running; end Fired");
}

void tst_Adopts::anAdoptWhoseGoalHoldsSucceedsAtOnce() {
    Trial trial("((AD keep ((goal ((there))) (walk))) (DC d (drives ((work keep)))))");
    trial.host.setSense("there", true);
    QCOMPARE(trial.cycle(0), "start work; sense there -> true T; goal keep; succeeded work; end NoAction");
}

void tst_Adopts::whatSucceedsIsDoneAgain() {
    Trial trial("((AD keep ((goal ((there))) (walk))) (DC d (drives ((work keep)))))");
    QVERIFY(trial.cycle(0).endsWith("done walk finished; end Fired"));
    QCOMPARE(trial.cycle(1), "sense there -> nil F; init walk; run walk -> RunningOnce; done walk finished; end Fired");
}

void tst_Adopts::theInnermostIsKept() {
    Trial trial("((AD outer ((goal ((x))) (p))) (AP p (one inner)) (AD inner ((goal ((y))) (walk))) "
                "(DC d (drives ((high (trigger ((danger))) dodge)) ((low outer)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    QVERIFY(trial.cycle(1).contains("init walk"));
    trial.host.setSense("danger", true);
    trial.cycle(2);
    trial.host.setSense("danger", false);
    QCOMPARE(trial.cycle(3), "sense danger -> false F; sense x -> nil F; sense y -> nil F; init walk; run walk -> "
                             "Running; end Fired");
}

void tst_Adopts::aSatisfiedGoalEndsARunningAct() {
    Trial trial("((AD keep ((goal ((there))) (walk))) (DC d (drives ((work keep)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.host.setSense("there", true);
    QCOMPARE(trial.cycle(1), "sense there -> true T; goal keep; done walk interrupted; succeeded work; end NoAction");
}

void tst_Adopts::anInnerGoalLeavesTheAdoptForTheNextCycle() {
    Trial trial(
        "((AD keep ((goal ((there))) (c))) (C c (goal ((full))) (elements ((e eat)))) (DC d (drives ((work keep)))))");
    trial.host.setSense("full", true);
    QCOMPARE(trial.cycle(0), "start work; sense there -> nil F; sense full -> true T; goal c; end NoAction");
    trial.host.setSense("full", false);
    QVERIFY(trial.cycle(1).contains("init eat"));
}

USAR_TEST(tst_Adopts)

} // namespace tst_adopts

#include "tst_adopts.moc"
