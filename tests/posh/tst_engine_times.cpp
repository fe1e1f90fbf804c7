// Time limits, frequencies and retries, to the millisecond and the cycle at which they take effect.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_engine_times {

using namespace usar::posh;

class tst_EngineTimes : public QObject {
    Q_OBJECT
private slots:
    void aLimitEndsAFormAtItsMillisecond_data();
    void aLimitEndsAFormAtItsMillisecond();
    void aLimitOfZeroIsAlwaysExceeded();
    void noneZeroIsNoLimit();
    void anOuterLimitEndsWhatIsBelowIt();
    void aFrequencyEndsAtItsMillisecond_data();
    void aFrequencyEndsAtItsMillisecond();
    void ticksCountCyclesAndNotTime_data();
    void ticksCountCyclesAndNotTime();
    void anotherProgramForgetsTheFrequency();
    void retriesAreStartsInOneEngagement_data();
    void retriesAreStartsInOneEngagement();
    void retriesCountAgainAfterAStop();
    void anotherLimitHoldsAtOnceAndTheCountStays();
    void aDriveThatIsSwitchedOffStopsAtOnce();
    void theBudgetIsTheNumberOfActs_data();
    void theBudgetIsTheNumberOfActs();
};

void tst_EngineTimes::aLimitEndsAFormAtItsMillisecond_data() {
    QTest::addColumn<QByteArray>("limit");
    QTest::addColumn<int>("limit_ms");
    QTest::newRow("an hour") << QByteArray("(hours 1)") << 3'600'000;
    QTest::newRow("half an hour") << QByteArray("(hours 0.5)") << 1'800'000;
    QTest::newRow("two minutes") << QByteArray("(minutes 2)") << 120'000;
    QTest::newRow("a second and a half") << QByteArray("(seconds 1.5)") << 1500;
    QTest::newRow("milliseconds") << QByteArray("(none 250)") << 250;
    QTest::newRow("less than a millisecond") << QByteArray("(seconds 0.0005)") << 1;
    QTest::newRow("part of a millisecond counts as a whole one") << QByteArray("(none 9.2)") << 10;
    QTest::newRow("letters of any case") << QByteArray("(SECONDS 3)") << 3000;
}

void tst_EngineTimes::aLimitEndsAFormAtItsMillisecond() {
    QFETCH(QByteArray, limit);
    QFETCH(int, limit_ms);
    const std::string words = limit.toStdString();
    Trial pattern("((AP p " + words + " (walk sit)) (DC d (drives ((work p)))))");
    pattern.host.setResult("walk", running);
    pattern.cycle(100);
    QCOMPARE(pattern.cycle(100 + limit_ms - 1), "run walk -> Running; end Fired");
    QCOMPARE(pattern.cycle(100 + limit_ms), "timeout p; done walk interrupted; failed work; end NoAction");
    QCOMPARE(pattern.cycle(200 + limit_ms), "start work; init walk; run walk -> Running; end Fired");

    Trial competence("((C c " + words + " (elements ((e walk)))) (DC d (drives ((work c)))))");
    competence.cycle(100);
    QVERIFY(competence.cycle(100 + limit_ms - 1).contains("run walk"));
    QCOMPARE(competence.cycle(100 + limit_ms), "start work; timeout c; failed work; end NoAction");
    QVERIFY(competence.cycle(100 + limit_ms).contains("run walk")); // A new engagement
}

void tst_EngineTimes::aLimitOfZeroIsAlwaysExceeded() {
    Trial competence("((C c (seconds 0) (elements ((e walk)))) (DC d (drives ((work c)))))");
    for (const int time_ms : {0, 0, 500})
        QCOMPARE(competence.cycle(time_ms), "start work; timeout c; failed work; end NoAction");
    Trial pattern("((AP p (seconds 0) (walk sit)) (DC d (drives ((work p)))))");
    pattern.host.setResult("walk", running);
    QCOMPARE(pattern.cycle(0), "start work; init walk; run walk -> Running; end Fired"); // It is asked when it goes on
    QCOMPARE(pattern.cycle(0), "timeout p; done walk interrupted; failed work; end NoAction");
}

void tst_EngineTimes::noneZeroIsNoLimit() {
    Trial trial("((C c (none 0) (elements ((e walk)))) (DC d (drives ((work c)))))");
    trial.host.setResult("walk", running);
    for (const int time_ms : {0, 1, 1'000'000'000})
        QVERIFY(trial.cycle(time_ms).contains("run walk -> Running"));
}

void tst_EngineTimes::anOuterLimitEndsWhatIsBelowIt() {
    Trial trial("((AP outer (seconds 1) (inner sit)) (AP inner (seconds 9) (walk)) (DC d (drives ((work outer)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    QCOMPARE(trial.cycle(999), "run walk -> Running; end Fired");
    QCOMPARE(trial.cycle(1000), "timeout outer; done walk interrupted; failed work; end NoAction");
}

void tst_EngineTimes::aFrequencyEndsAtItsMillisecond_data() {
    QTest::addColumn<QByteArray>("frequency");
    QTest::addColumn<int>("interval_ms");
    QTest::newRow("hours") << QByteArray("(hours 1)") << 3'600'000;
    QTest::newRow("minutes") << QByteArray("(minutes 0.5)") << 30'000;
    QTest::newRow("seconds") << QByteArray("(seconds 0.25)") << 250;
    QTest::newRow("milliseconds") << QByteArray("(none 10)") << 10;
    QTest::newRow("eight a second") << QByteArray("(hz 8)") << 125;
    QTest::newRow("three a second, which is not a whole number") << QByteArray("(hz 3)") << 334;
    QTest::newRow("less than one a second") << QByteArray("(hz 0.5)") << 2000;
    QTest::newRow("240 a minute") << QByteArray("(pm 240)") << 250;
    QTest::newRow("seven a minute") << QByteArray("(pm 7)") << 8572;
}

void tst_EngineTimes::aFrequencyEndsAtItsMillisecond() {
    QFETCH(QByteArray, frequency);
    QFETCH(int, interval_ms);
    Trial trial("((DC d (drives ((beat drum " + frequency.toStdString() + ")))))");
    QVERIFY(trial.cycle(70).startsWith("start beat"));
    QCOMPARE(trial.cycle(70), "skip frequency; end Idle");
    QCOMPARE(trial.cycle(70 + interval_ms - 1), "skip frequency; end Idle");
    QVERIFY(trial.cycle(70 + interval_ms).startsWith("start beat"));
    QCOMPARE(trial.cycle(70 + 2 * interval_ms - 1), "skip frequency; end Idle");
}

void tst_EngineTimes::ticksCountCyclesAndNotTime_data() {
    QTest::addColumn<QByteArray>("ticks");
    QTest::addColumn<QList<int>>("starts"); // of eight cycles, counted from 1
    QTest::newRow("none") << QByteArray("(ticks 0)") << QList<int>{1, 2, 3, 4, 5, 6, 7, 8};
    QTest::newRow("each cycle") << QByteArray("(ticks 1)") << QList<int>{1, 2, 3, 4, 5, 6, 7, 8};
    QTest::newRow("every third") << QByteArray("(ticks 3)") << QList<int>{1, 4, 7};
    QTest::newRow("part of a cycle counts as a whole one") << QByteArray("(ticks 2.5)") << QList<int>{1, 4, 7};
    QTest::newRow("never again") << QByteArray("(ticks 1e18)") << QList<int>{1};
}

void tst_EngineTimes::ticksCountCyclesAndNotTime() {
    QFETCH(QByteArray, ticks);
    QFETCH(QList<int>, starts);
    Trial trial("((DC d (drives ((beat drum " + ticks.toStdString() + ")))))");
    QList<int> started;
    for (int cycle = 1; cycle <= 8; ++cycle)
        if (trial.cycle(cycle == 5 ? 1'000'000 : 0).contains("start beat")) // The time stays at a million from then on
            started << cycle;
    QCOMPARE(started, starts);
}

void tst_EngineTimes::anotherProgramForgetsTheFrequency() {
    const std::string plan = "((DC d (drives ((beat drum (hours 1))))))";
    Trial trial(plan);
    QVERIFY(trial.cycle(0).startsWith("start beat"));
    QCOMPARE(trial.cycle(1), "skip frequency; end Idle");
    trial.engine.retune(programOf(plan));
    QCOMPARE(trial.cycle(2), "skip frequency; end Idle");
    trial.engine.replace(programOf(plan));
    QVERIFY(trial.cycle(3).startsWith("start beat"));
}

void tst_EngineTimes::retriesAreStartsInOneEngagement_data() {
    QTest::addColumn<int>("retries");
    QTest::addColumn<ActResult>("result");
    for (const int retries : {1, 2, 5}) {
        QTest::addRow("%d that end in their cycle", retries) << retries << ActResult::RunningOnce;
        QTest::addRow("%d that fail", retries) << retries << ActResult::Failed;
    }
}

void tst_EngineTimes::retriesAreStartsInOneEngagement() {
    QFETCH(int, retries);
    QFETCH(ActResult, result);
    Trial trial("((C c (elements ((e poke " + std::to_string(retries) + ")) ((f sit)))) (DC d (drives ((work c)))))");
    trial.host.setResult("poke", result);
    for (int cycle = 0; cycle < retries; ++cycle)
        QVERIFY(trial.cycle(cycle).contains("select e; init poke"));
    for (int cycle = 0; cycle < 3; ++cycle)
        QVERIFY(trial.cycle(retries + cycle).contains("skip retries; select f; init sit"));
}

void tst_EngineTimes::retriesCountAgainAfterAStop() {
    Trial trial("((C c (elements ((e poke 1)) ((f sit)))) (DC d (drives ((work c)))))");
    QVERIFY(trial.cycle(0).contains("select e"));
    QVERIFY(trial.cycle(1).contains("select f"));
    trial.engine.stop();
    QVERIFY(trial.cycle(2).contains("select e"));
}

void tst_EngineTimes::anotherLimitHoldsAtOnceAndTheCountStays() {
    const auto plan = [](int retries) {
        return "((C c (elements ((e poke " + std::to_string(retries) + ")) ((f sit)))) (DC d (drives ((work c)))))";
    };
    Trial trial(plan(1));
    QVERIFY(trial.cycle(0).contains("select e"));
    QVERIFY(trial.cycle(1).contains("skip retries"));
    trial.engine.retune(programOf(plan(3)));
    QVERIFY(trial.cycle(2).contains("select e"));
    QVERIFY(trial.cycle(3).contains("select e"));
    QVERIFY(trial.cycle(4).contains("skip retries"));
    trial.engine.retune(programOf(plan(0)));
    QVERIFY(trial.cycle(5).contains("select e"));
}

void tst_EngineTimes::aDriveThatIsSwitchedOffStopsAtOnce() {
    Trial trial("((DC d (drives ((work walk)))))");
    trial.host.setResult("walk", running);
    trial.cycle(0);
    trial.engine.switchDrive(0, false);
    QCOMPARE(trial.cycle(1), "skip off; done walk interrupted; interrupt work; end Idle");
    QCOMPARE(trial.cycle(2), "skip off; end Idle");
    trial.engine.switchDrive(0, true);
    QCOMPARE(trial.cycle(3), "start work; init walk; run walk -> Running; end Fired");
}

void tst_EngineTimes::theBudgetIsTheNumberOfActs_data() {
    QTest::addColumn<int>("most_acts");
    QTest::addColumn<int>("runs");
    QTest::newRow("negative") << -1 << 1;
    QTest::newRow("zero") << 0 << 1;
    QTest::newRow("one") << 1 << 1;
    QTest::newRow("seven") << 7 << 7;
}

void tst_EngineTimes::theBudgetIsTheNumberOfActs() {
    QFETCH(int, most_acts);
    QFETCH(int, runs);
    Trial trial("((DC d (drives ((work tick)))))", {.most_acts = most_acts});
    trial.host.setResult("tick", ActResult::Finished);
    const QString events = trial.cycle(0);
    QCOMPARE(events.count("run tick -> Finished"), runs);
    QVERIFY2(events.endsWith("warn budget; end Budget"), qPrintable(events));
}

USAR_TEST(tst_EngineTimes)

} // namespace tst_engine_times

#include "tst_engine_times.moc"
