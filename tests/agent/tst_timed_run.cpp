#include <QObject>
#include <QTest>

#include "core/agent/timed_behavior.h"
#include "tests/suite/suite.h"

namespace tst_timed_run {

using namespace usar;
using namespace usar::agent;

class tst_TimedRun : public QObject {
    Q_OBJECT

private slots:
    void itsTimeBeginsWithTheFirstTick() {
        TimedRun run;
        QCOMPARE(run.elapsed().count(), 0.0);
        QCOMPARE(run.step(Seconds(100.0)).count(), 0.0);
        QCOMPARE(run.step(Seconds(100.5)).count(), 0.5);
        QCOMPARE(run.elapsed().count(), 0.5);
    }

    void isOverAfterItsTimeUnlessSomethingElseEndedIt() {
        TimedRun run;
        run.step(Seconds(50.0));
        run.step(Seconds(59.0));
        QVERIFY(!run.isOver(Seconds(10.0)));
        QVERIFY(!run.isOver(Seconds(0.0))); // for good
        run.step(Seconds(60.0));
        QVERIFY(run.isOver(Seconds(10.0)));
        run.order(Order::LandNow);
        QVERIFY(!run.isOver(Seconds(10.0)));
    }

    void aPersonPausesResumesAndEndsIt() {
        TimedRun run;
        QVERIFY(run.order(Order::Pause));
        QVERIFY(run.status({}, 0.0).paused);
        run.order(Order::Resume);
        QVERIFY(!run.status({}, 0.0).paused && !run.ending);
        run.order(Order::LandNow);
        QVERIFY(run.ending && !run.ending->success);
    }

    void tellsProgressWhereThereIsAWhole() {
        TimedRun run;
        run.step(Seconds(10.0));
        run.step(Seconds(12.0));
        run.state = "walking";
        const BehaviorStatus endless = run.status({}, 3.0);
        QVERIFY(!endless.progress_pct && !endless.time_left);
        QCOMPARE(endless.state, std::string("walking"));
        QCOMPARE(endless.distance_flown_m, 3.0);
        QCOMPARE(*run.status(Seconds(8.0), 3.0).progress_pct, 25.0);
        QCOMPARE(run.status(Seconds(8.0), 3.0).time_left->count(), 6.0);
        QCOMPARE(*run.status(Seconds(1.0), 3.0).progress_pct, 100.0);
        QCOMPARE(run.status(Seconds(1.0), 3.0).time_left->count(), 0.0);
    }
};

USAR_TEST(tst_TimedRun)

} // namespace tst_timed_run

#include "tst_timed_run.moc"
