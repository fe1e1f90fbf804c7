// What the engine does for each element of a plan, with the smallest plan that shows it.
#include <QTest>

#include "tests/posh/trial.h"

using namespace usar::posh;

namespace {

const auto running = ActResult::Running;

const auto failed = ActResult::Failed;

} // namespace

class tst_Engine : public QObject {
    Q_OBJECT
private slots:
    void aDriveThatIsReadyRunsItsAct();
    void noDriveIsReadyThenItIdles();
    void theFirstReadyDriveWins();
    void aDriveWithFrequencyWaitsForItsInterval_data();
    void aDriveWithFrequencyWaitsForItsInterval();
    void aSwitchedOffDriveIsNeverReady();
    void timeNeverGoesBack();

    void aCompetenceSucceedsWithItsElement();
    void aCompetenceWithoutReadyElementFails();
    void aSatisfiedGoalEndsACompetenceBeforeItActs();
    void retriesCountStartsNotCycles();
    void retriesOfANestedCompetenceCountStartsToo();
    void engagementsEndWhenACycleDoesNotVisit();

    void aPatternRestartsAfterAnInterruption();
    void aPatternInsideACompetenceIsNotReexamined();
    void aTimedPatternFailsAtItsLimit_data();
    void aTimedPatternFailsAtItsLimit();

    void anAdoptTriesAgainAfterFailure();
    void anAdoptKeepsItsPlaceWhenInterrupted();
    void anAdoptWhoseGoalHoldsSucceedsAtOnce();

    void defaultsServeWhereArgumentsAreMissing();
    void aDeepChainOfFormsRuns();
};

void tst_Engine::aDriveThatIsReadyRunsItsAct() {
    Trial trial("((DC d (drives ((work walk)))))");
    QCOMPARE(trial.cycle(0),
             "start work; init walk; run walk -> RunningOnce; done walk finished; succeeded work; end Fired");
    QCOMPARE(trial.host.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

void tst_Engine::noDriveIsReadyThenItIdles() {
    Trial trial("((DC d (drives ((work (trigger ((on))) walk)))))");
    QCOMPARE(trial.cycle(0), "sense on -> nil F; end Idle");
}

void tst_Engine::theFirstReadyDriveWins() {
    Trial trial("((DC d (drives ((a (trigger ((s1) (s2))) one)) ((b (trigger ((s1))) two)) ((c three)))))");
    trial.host.setSense("s1", true);
    QCOMPARE(trial.cycle(0), "sense s1 -> true T; sense s2 -> nil F; sense s1 -> true T cached; start b; init two; "
                             "run two -> RunningOnce; done two finished; succeeded b; end Fired");
}

void tst_Engine::aDriveWithFrequencyWaitsForItsInterval_data() {
    QTest::addColumn<QByteArray>("frequency");
    QTest::addColumn<QList<int>>("starts"); // cycles that start it, of ten that are 500 ms apart
    QTest::newRow("none: no limit") << QByteArray("(none 0)") << QList<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    QTest::newRow("seconds") << QByteArray("(seconds 2)") << QList<int>{0, 4, 8};
    QTest::newRow("not a whole number of cycles") << QByteArray("(seconds 1.2)") << QList<int>{0, 3, 6, 9};
    QTest::newRow("hertz") << QByteArray("(hz 1)") << QList<int>{0, 2, 4, 6, 8};
    QTest::newRow("a minute") << QByteArray("(pm 30)") << QList<int>{0, 4, 8};
    QTest::newRow("milliseconds") << QByteArray("(none 1500)") << QList<int>{0, 3, 6, 9};
    QTest::newRow("cycles") << QByteArray("(ticks 5)") << QList<int>{0, 5};
    QTest::newRow("hours") << QByteArray("(hours 1)") << QList<int>{0};
}

void tst_Engine::aDriveWithFrequencyWaitsForItsInterval() {
    QFETCH(QByteArray, frequency);
    QFETCH(QList<int>, starts);
    Trial trial("((DC d (drives ((beat drum " + frequency.toStdString() + ")) ((rest sit)))))");
    QList<int> started;
    for (int cycle = 0; cycle < 10; ++cycle)
        if (trial.cycle(500 * cycle).contains("start beat"))
            started << cycle;
    QCOMPARE(started, starts);
}

void tst_Engine::aSwitchedOffDriveIsNeverReady() {
    Trial trial("((DC d (drives ((high up)) ((low down)))))");
    trial.engine.switchDrive(0, false);
    QVERIFY(trial.cycle(0).startsWith("skip off; start low"));
    trial.engine.switchDrive(0, true);
    QVERIFY(trial.cycle(1).startsWith("start high"));
}

void tst_Engine::timeNeverGoesBack() {
    Trial trial("((DC d (drives ((beat drum (seconds 1))))))");
    trial.cycle(5000);
    QCOMPARE(trial.cycle(100), "skip frequency; end Idle");
    QVERIFY(trial.cycle(6000).startsWith("start beat"));
}

void tst_Engine::aCompetenceSucceedsWithItsElement() {
    Trial trial("((C c (elements ((e walk)))) (DC d (drives ((work c)))))");
    QCOMPARE(trial.cycle(0),
             "start work; select e; init walk; run walk -> RunningOnce; done walk finished; succeeded work; end Fired");
}

void tst_Engine::aCompetenceWithoutReadyElementFails() {
    Trial trial("((C c (elements ((e (trigger ((on))) walk)))) (DC d (drives ((work c)) ((rest sit)))))");
    QCOMPARE(trial.cycle(0), "start work; sense on -> nil F; noelement c; failed work; end NoAction");
}

void tst_Engine::aSatisfiedGoalEndsACompetenceBeforeItActs() {
    Trial trial("((C c (goal ((there))) (elements ((e walk)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.host.setSense("there", true);
    QCOMPARE(trial.cycle(1), "sense there -> true T; goal c; done walk interrupted; succeeded work; end NoAction");
}

void tst_Engine::retriesCountStartsNotCycles() {
    Trial trial("((C c (elements ((e walk 2)) ((f sit)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    for (int cycle = 0; cycle < 5; ++cycle)
        QVERIFY(trial.cycle(cycle).contains("run walk -> Running"));
    trial.host.setResult("walk", failed);
    QVERIFY(trial.cycle(5).contains("done walk failed"));
    QVERIFY(trial.cycle(6).contains("init walk"));
    QVERIFY(trial.cycle(7).contains("skip retries; select f"));
}

void tst_Engine::retriesOfANestedCompetenceCountStartsToo() {
    Trial trial(
        "((C c (elements ((e inner 1)) ((f sit)))) (C inner (elements ((i walk)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    for (int cycle = 0; cycle < 5; ++cycle)
        QVERIFY(trial.cycle(cycle).contains("run walk -> Running"));
}

void tst_Engine::engagementsEndWhenACycleDoesNotVisit() {
    Trial trial(
        "((C c (elements ((e poke 1)) ((f sit)))) (DC d (drives ((other (trigger ((busy))) sing)) ((work c)))))");
    QVERIFY(trial.cycle(0).contains("select e"));
    QVERIFY(trial.cycle(1).contains("skip retries; select f"));
    trial.host.setSense("busy", true);
    trial.cycle(2);
    trial.host.setSense("busy", false);
    QVERIFY(trial.cycle(3).contains("select e"));
}

void tst_Engine::aPatternRestartsAfterAnInterruption() {
    Trial trial("((AP p (one two)) (DC d (drives ((high (trigger ((danger))) dodge)) ((low p)))))");
    QVERIFY(trial.cycle(0).contains("init one"));
    trial.host.setResult("two", running);
    QVERIFY(trial.cycle(1).contains("init two"));
    trial.host.setSense("danger", true);
    QVERIFY(trial.cycle(2).contains("done two interrupted; interrupt low; start high"));
    trial.host.setSense("danger", false);
    QVERIFY(trial.cycle(3).contains("start low; init one"));
}

void tst_Engine::aPatternInsideACompetenceIsNotReexamined() {
    Trial trial("((C c (elements ((e (trigger ((on))) p)))) (AP p (one two)) (DC d (drives ((work c)))))");
    trial.host.setSense("on", true);
    trial.cycle(0);
    trial.host.setSense("on", false);
    QCOMPARE(trial.cycle(1), "init two; run two -> RunningOnce; done two finished; succeeded work; end Fired");
}

void tst_Engine::aTimedPatternFailsAtItsLimit_data() {
    QTest::addColumn<QByteArray>("limit");
    QTest::addColumn<int>("times_out_in"); // of ten cycles that are 200 ms apart; -1: in none
    QTest::newRow("between two cycles") << QByteArray("(seconds 0.5)") << 3;
    QTest::newRow("on a cycle") << QByteArray("(seconds 0.6)") << 3;
    QTest::newRow("milliseconds") << QByteArray("(none 1000)") << 5;
    QTest::newRow("none") << QByteArray("(none 0)") << -1;
    QTest::newRow("nil") << QByteArray("nil") << -1;
}

void tst_Engine::aTimedPatternFailsAtItsLimit() {
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

void tst_Engine::anAdoptTriesAgainAfterFailure() {
    Trial trial("((AD keep ((goal ((there))) (p))) (AP p (one two)) (DC d (drives ((work keep)))))");
    trial.host.setResult("two", failed);
    trial.cycle(0);
    QCOMPARE(trial.cycle(1),
             "sense there -> nil F; init two; run two -> Failed; done two failed; retry keep; end Fired");
    QVERIFY(trial.cycle(2).contains("init one"));
}

void tst_Engine::anAdoptKeepsItsPlaceWhenInterrupted() {
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

void tst_Engine::anAdoptWhoseGoalHoldsSucceedsAtOnce() {
    Trial trial("((AD keep ((goal ((there))) (walk))) (DC d (drives ((work keep)))))");
    trial.host.setSense("there", true);
    QCOMPARE(trial.cycle(0), "start work; sense there -> true T; goal keep; succeeded work; end NoAction");
}

void tst_Engine::defaultsServeWhereArgumentsAreMissing() {
    Trial trial("((AP p vars($a=1, $b='red) (fly($b, $x=$a))) (DC d (drives ((one p) (two p(2.0, $b=\"blue\"))))))");
    QVERIFY(trial.cycle(0).contains("init fly('red, $x=1)"));
    QVERIFY(trial.cycle(1).contains("init fly(\"blue\", $x=2.0)"));
}

void tst_Engine::aDeepChainOfFormsRuns() {
    std::string plan = "((DC d (drives ((work c0))))";
    for (int i = 0; i < 5000; ++i)
        plan += "(C c" + std::to_string(i) + " (elements ((e " +
                (i == 4999 ? std::string("walk") : "c" + std::to_string(i + 1)) + "))))";
    Trial trial(plan + ")");
    trial.engine.watch(nullptr); // the text of such paths is long
    QCOMPARE(trial.engine.cycle(Milliseconds(0)), Outcome::Fired);
    QCOMPARE(trial.host.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

QTEST_APPLESS_MAIN(tst_Engine)
#include "tst_engine.moc"
