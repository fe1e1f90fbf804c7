// What the engine does when host or plan misbehave, when it is stopped, and when its plan is replaced.
#include <QTest>

#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_engine_faults {

using namespace usar::posh;
using usar::test::TraceDetail;

namespace {

const EngineOptions usual;

/// Every look at it takes 25 ms.
class SlowClock final : public ProfileClock {
public:
    std::int64_t nanoseconds() override { return time_ns_ += 25'000'000; }

private:
    std::int64_t time_ns_ = 0;
};

} // namespace

class tst_EngineFaults : public QObject {
    Q_OBJECT
private slots:
    void whatThrowsIsReportedByPlace_data();
    void whatThrowsIsReportedByPlace();
    void aSenseThatThrowsDoesNotHoldWhateverIsAsked();
    void unlikeTypesAreWarnedOfOnce();
    void aPlanThatSpinsStopsAtItsBudget();
    void aStarvingDriveIsReportedOnceInARow();
    void aSlowPrimitiveIsReported();
    void aRunOfStopEndsTheAct();
    void theEndOfTheEngineEndsTheAct();
    void aReplacedPlanBeginsAnew();
    void aRetunedPlanGoesOnByItsNewNumbers();
    void aWonPlanStaysWonUntilItIsReplaced();
    void aHeldPlanGoesOn();
    void builtInsServeUnlessTheHostHasTheName();
    void plansThatCannotRunSayWhy_data();
    void plansThatCannotRunSayWhy();
};

void tst_EngineFaults::whatThrowsIsReportedByPlace_data() {
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<QString>("cycle");
    QTest::newRow("sense") << QByteArray("sense on")
                           << "error sense on failed; sense on -> nil F; start rest; init sit; run sit -> RunningOnce; "
                              "done sit finished; succeeded rest; end Fired";
    QTest::newRow("init") << QByteArray("init walk")
                          << "sense on -> true T; start work; init walk; error init walk failed; done walk failed; "
                             "failed work; end Fired";
    QTest::newRow("run") << QByteArray("run walk")
                         << "sense on -> true T; start work; init walk; error run walk failed; run walk -> Failed; "
                            "done walk failed; failed work; end Fired";
    QTest::newRow("done") << QByteArray("done walk")
                          << "sense on -> true T; start work; init walk; run walk -> RunningOnce; done walk finished; "
                             "error done walk failed; succeeded work; end Fired";
}

void tst_EngineFaults::whatThrowsIsReportedByPlace() {
    QFETCH(QByteArray, what);
    QFETCH(QString, cycle);
    Trial trial("((DC d (drives ((work (trigger ((on))) walk)) ((rest sit)))))", usual, TraceDetail::Full);
    trial.host.setSense("on", true);
    trial.host.throws.insert(what.toStdString());
    QCOMPARE(trial.cycle(0), cycle);
}

void tst_EngineFaults::aSenseThatThrowsDoesNotHoldWhateverIsAsked() {
    Trial trial("((DC d (drives ((a (trigger ((on nil))) one)) ((b (trigger ((on 5 !=))) two)))))");
    trial.host.throws.insert("sense on");
    QCOMPARE(trial.cycle(0), "sense on -> nil F; sense on -> nil F cached; end Idle");
}

void tst_EngineFaults::unlikeTypesAreWarnedOfOnce() {
    Trial trial("((DC d (drives ((a (trigger ((n \"x\" <))) one)))))", usual, TraceDetail::Full);
    trial.host.setSense("n", 5.0);
    QVERIFY(trial.cycle(0).contains("warn"));
    QVERIFY(!trial.cycle(1).contains("warn"));
}

void tst_EngineFaults::aPlanThatSpinsStopsAtItsBudget() {
    Trial trial("((DC d (drives ((a tick)))))");
    trial.host.setResult("tick", ActResult::Finished);
    const QString cycle = trial.cycle(0);
    QCOMPARE(cycle.count("run tick"), 16);
    QVERIFY(cycle.endsWith("warn budget; end Budget"));
}

void tst_EngineFaults::aStarvingDriveIsReportedOnceInARow() {
    Trial trial("((C c (elements ((e (trigger ((on))) walk)))) (DC d (drives ((work c)))))", usual, TraceDetail::Full);
    QList<int> warned;
    for (int cycle = 1; cycle <= 40; ++cycle) {
        trial.host.setSense("on", cycle == 15);
        if (trial.cycle(cycle).contains("starving"))
            warned << cycle;
    }
    QCOMPARE(warned, (QList<int>{10, 25}));
}

void tst_EngineFaults::aSlowPrimitiveIsReported() {
    SlowClock clock;
    EngineOptions options;
    options.clock = &clock;
    Trial trial("((DC d (drives ((a walk)))))", options, TraceDetail::Full);
    QVERIFY(trial.cycle(0).contains("warn slow"));
    options.slow = Milliseconds(200);
    Trial patient("((DC d (drives ((a walk)))))", options, TraceDetail::Full);
    QVERIFY(!patient.cycle(0).contains("warn slow"));
}

void tst_EngineFaults::aRunOfStopEndsTheAct() {
    Trial trial("((AP p (one two)) (DC d (drives ((a p)))))");
    trial.cycle(0);
    trial.host.setResult("two", ActResult::Running);
    trial.cycle(1);
    trial.engine.stop();
    QCOMPARE(trial.taken(), "done two stopped");
    trial.engine.stop();
    QCOMPARE(trial.taken(), "");
    QVERIFY(trial.cycle(2).startsWith("start a; init one"));
}

void tst_EngineFaults::theEndOfTheEngineEndsTheAct() {
    TrialHost host;
    host.setResult("walk", ActResult::Running);
    {
        Engine engine(host, programOf("((DC d (drives ((a walk)))))"));
        engine.cycle(Milliseconds(0));
    }
    QCOMPARE(host.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

void tst_EngineFaults::aReplacedPlanBeginsAnew() {
    Trial trial("((DC d (drives ((a walk)))))");
    trial.host.setResult("walk", ActResult::Running);
    trial.cycle(0);
    trial.engine.replace(programOf("((DC d (drives ((b swim)))))"));
    QCOMPARE(trial.taken(), "done walk stopped");
    QCOMPARE(trial.cycle(1), "start b; init swim; run swim -> RunningOnce; done swim finished; succeeded b; end Fired");
    QCOMPARE(trial.engine.cycleNumber(), std::uint64_t(2));
}

void tst_EngineFaults::aRetunedPlanGoesOnByItsNewNumbers() {
    Trial trial("((DC d (drives ((near (trigger ((distance 1 <))) stop)) ((a walk)))))");
    trial.host.setResult("walk", ActResult::Running);
    trial.host.setSense("distance", 2.0);
    trial.cycle(0);
    trial.engine.retune(programOf("((DC d (drives ((close (trigger ((distance 0.5 <))) stop)) ((a walk)))))"));
    QCOMPARE(trial.taken(), "");
    QCOMPARE(trial.cycle(1), "sense distance -> 2.0 F; run walk -> Running; end Fired");
    trial.engine.retune(programOf("((DC d (drives ((far (trigger ((distance 3 <))) stop)) ((a walk)))))"));
    QCOMPARE(trial.cycle(2), "sense distance -> 2.0 T; done walk interrupted; interrupt a; start far; init stop; "
                             "run stop -> RunningOnce; done stop finished; succeeded far; end Fired");
}

void tst_EngineFaults::aWonPlanStaysWonUntilItIsReplaced() {
    const std::string plan = "((DC d (goal ((over))) (drives ((a walk)))))";
    Trial trial(plan);
    trial.host.setSense("over", true);
    QCOMPARE(trial.cycle(0), "sense over -> true T; end GoalSatisfied");
    QCOMPARE(trial.cycle(1), "end Won");
    QVERIFY(trial.engine.won());
    trial.host.setSense("over", false);
    trial.engine.replace(programOf(plan));
    QVERIFY(trial.cycle(2).contains("start a"));
}

void tst_EngineFaults::aHeldPlanGoesOn() {
    EngineOptions hold;
    hold.on_goal = OnGoal::Hold;
    Trial trial("((DC d (goal ((over))) (drives ((a walk)))))", hold);
    trial.host.setResult("walk", ActResult::Running);
    trial.cycle(0);
    trial.host.setSense("over", true);
    QCOMPARE(trial.cycle(1), "sense over -> true T; done walk goal; end GoalSatisfied");
    QCOMPARE(trial.cycle(2), "sense over -> true T; end GoalSatisfied");
    trial.host.setSense("over", false);
    QVERIFY(trial.cycle(3).contains("start a; init walk"));
}

void tst_EngineFaults::builtInsServeUnlessTheHostHasTheName() {
    Trial trial("((DC d (drives ((a (trigger ((fail))) one)) ((b (trigger ((succeed))) doNothing)))))");
    QCOMPARE(trial.cycle(0), "sense fail -> false F; sense succeed -> true T; start b; init doNothing; run doNothing "
                             "-> RunningOnce; done doNothing finished; succeeded b; end Fired");
    QVERIFY(trial.host.calls.empty());
    trial.host.setSense("succeed", false);
    trial.engine.replace(trial.engine.program());
    QVERIFY(trial.cycle(1).contains("sense succeed -> false F"));
}

void tst_EngineFaults::plansThatCannotRunSayWhy_data() {
    QTest::addColumn<QByteArray>("plan");
    QTest::addColumn<QString>("what");
    QTest::newRow("fragment") << QByteArray("((AP p (a)))") << "the plan has no drive collection";
    QTest::newRow("circle") << QByteArray("((C a (elements ((e b)))) (AP b (a)) (DC d (drives ((x a)))))")
                            << "leads back to itself";
    QTest::newRow("value without a name")
        << QByteArray("((AP p (fly($x))) (DC d (drives ((a p)))))") << "$x has no value here";
    QByteArray doubling = "((DC d (drives ((a p0))))";
    for (int i = 0; i < 30; ++i) {
        const QByteArray next = i == 29 ? "end" : "p" + QByteArray::number(i + 1);
        doubling += "(AP p" + QByteArray::number(i) + " (" + next + " " + next + "))";
    }
    QTest::newRow("a plan that doubles with each level") << doubling + ")"
                                                         << "more than 1000000 places";
}

void tst_EngineFaults::plansThatCannotRunSayWhy() {
    QFETCH(QByteArray, plan);
    QFETCH(QString, what);
    const auto program = compile(readPlan(plan.toStdString()).plan);
    QVERIFY(!program);
    QVERIFY2(QString::fromStdString(program.error().text()).contains(what), program.error().text().c_str());
}

USAR_TEST(tst_EngineFaults)

} // namespace tst_engine_faults

#include "tst_engine_faults.moc"
