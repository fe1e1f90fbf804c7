// Drives: which one wins, how often it may start, and who takes turns.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_drives {

using namespace usar::posh;

class tst_Drives : public QObject {
    Q_OBJECT
private slots:
    void aDriveThatIsReadyRunsItsAct();
    void noDriveIsReadyThenItIdles();
    void theFirstReadyDriveWins();
    void aDriveWithFrequencyWaitsForItsInterval_data();
    void aDriveWithFrequencyWaitsForItsInterval();
    void aSwitchedOffDriveIsNeverReady();
    void timeNeverGoesBack();
    void aClockMayBeginBelowZero();
    void theFrequencyIsAskedBeforeTheTrigger();
    void theIntervalCountsFromTheStartNotTheEnd();
    void anInterruptedDriveWaitsForItsIntervalToo();
    void equalsTakeTurnsAsTheyEnd();
    void theEqualInProgressStays();
    void anEqualWhoseTriggerFailsMakesWay();
    void aGoalWithoutSensesNeverHolds();
    void allSensesOfTheGoalMustHold();
};

void tst_Drives::aDriveThatIsReadyRunsItsAct() {
    Trial trial("((DC d (drives ((work walk)))))");
    QCOMPARE(trial.cycle(0),
             "start work; init walk; run walk -> RunningOnce; done walk finished; succeeded work; end Fired");
    QCOMPARE(trial.host.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

void tst_Drives::noDriveIsReadyThenItIdles() {
    Trial trial("((DC d (drives ((work (trigger ((on))) walk)))))");
    QCOMPARE(trial.cycle(0), "sense on -> nil F; end Idle");
}

void tst_Drives::theFirstReadyDriveWins() {
    Trial trial("((DC d (drives ((a (trigger ((s1) (s2))) one)) ((b (trigger ((s1))) two)) ((c three)))))");
    trial.host.setSense("s1", true);
    QCOMPARE(trial.cycle(0), "sense s1 -> true T; sense s2 -> nil F; sense s1 -> true T cached; start b; init two; "
                             "run two -> RunningOnce; done two finished; succeeded b; end Fired");
}

void tst_Drives::aDriveWithFrequencyWaitsForItsInterval_data() {
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

void tst_Drives::aDriveWithFrequencyWaitsForItsInterval() {
    QFETCH(QByteArray, frequency);
    QFETCH(QList<int>, starts);
    Trial trial("((DC d (drives ((beat drum " + frequency.toStdString() + ")) ((rest sit)))))");
    QList<int> started;
    for (int cycle = 0; cycle < 10; ++cycle)
        if (trial.cycle(500 * cycle).contains("start beat"))
            started << cycle;
    QCOMPARE(started, starts);
}

void tst_Drives::aSwitchedOffDriveIsNeverReady() {
    Trial trial("((DC d (drives ((high up)) ((low down)))))");
    trial.engine.switchDrive(0, false);
    QVERIFY(trial.cycle(0).startsWith("skip off; start low"));
    trial.engine.switchDrive(0, true);
    QVERIFY(trial.cycle(1).startsWith("start high"));
}

void tst_Drives::timeNeverGoesBack() {
    Trial trial("((DC d (drives ((beat drum (seconds 1))))))");
    trial.cycle(5000);
    QCOMPARE(trial.cycle(100), "skip frequency; end Idle");
    QVERIFY(trial.cycle(6000).startsWith("start beat"));
}

void tst_Drives::aClockMayBeginBelowZero() {
    Trial trial("((DC d (drives ((beat drum (seconds 1))))))");
    trial.cycle(-5000);
    QCOMPARE(trial.cycle(-4500), "skip frequency; end Idle");
    QVERIFY(trial.cycle(-4000).startsWith("start beat"));
}

void tst_Drives::theFrequencyIsAskedBeforeTheTrigger() {
    Trial trial("((DC d (drives ((beat (trigger ((on))) drum (seconds 1))))))");
    trial.host.setSense("on", true);
    trial.cycle(0);
    QCOMPARE(trial.cycle(500), "skip frequency; end Idle");
}

void tst_Drives::theIntervalCountsFromTheStartNotTheEnd() {
    Trial trial("((AP p (one two three)) (DC d (drives ((beat p (seconds 1))) ((rest sit)))))");
    QList<int> started;
    for (int cycle = 0; cycle < 8; ++cycle)
        if (trial.cycle(500 * cycle).contains("start beat"))
            started << cycle;
    QCOMPARE(started, (QList<int>{0, 3, 6}));
}

void tst_Drives::anInterruptedDriveWaitsForItsIntervalToo() {
    Trial trial("((DC d (drives ((high (trigger ((danger))) dodge)) ((low walk (seconds 2))))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.host.setSense("danger", true);
    trial.cycle(500);
    trial.host.setSense("danger", false);
    QCOMPARE(trial.cycle(1000), "sense danger -> false F; skip frequency; end Idle");
    QVERIFY(trial.cycle(2000).contains("start low"));
}

void tst_Drives::equalsTakeTurnsAsTheyEnd() {
    Trial trial("((DC d (drives ((a one) (b two) (c three)))))");
    QStringList order;
    for (int cycle = 0; cycle < 6; ++cycle)
        order << trial.cycle(cycle).section(';', 0, 0);
    QCOMPARE(order, (QStringList{"start a", "start b", "start c", "start a", "start b", "start c"}));
}

void tst_Drives::theEqualInProgressStays() {
    Trial trial("((DC d (drives ((a one) (b two)))))");
    trial.host.setResult("one", running);
    trial.cycle(0);
    QCOMPARE(trial.cycle(1), "run one -> Running; end Fired");
}

void tst_Drives::anEqualWhoseTriggerFailsMakesWay() {
    Trial trial("((DC d (drives ((a (trigger ((on))) one) (b two)))))");
    trial.host.setSense("on", true);
    trial.host.setResult("one", running);
    trial.cycle(0);
    trial.host.setSense("on", false);
    QVERIFY(trial.cycle(1).startsWith("sense on -> false F; done one interrupted; interrupt a; start b"));
}

void tst_Drives::aGoalWithoutSensesNeverHolds() {
    Trial trial("((DC d (goal nil) (drives ((a one)))))");
    QVERIFY(trial.cycle(0).startsWith("start a"));
}

void tst_Drives::allSensesOfTheGoalMustHold() {
    Trial trial("((DC d (goal ((x) (y))) (drives ((a one)))))");
    trial.host.setSense("x", true);
    QVERIFY(trial.cycle(0).startsWith("sense x -> true T; sense y -> nil F; start a"));
    trial.host.setSense("y", 1.5);
    QCOMPARE(trial.cycle(1), "sense x -> true T; sense y -> 1.5 T; end GoalSatisfied");
}

USAR_TEST(tst_Drives)

} // namespace tst_drives

#include "tst_drives.moc"
