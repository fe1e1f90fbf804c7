#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/stuck_watch.h"
#include "tests/suite/suite.h"

namespace tst_stuck_watch {

using namespace usar;
using namespace usar::airrobot;

class tst_StuckWatch : public QObject {
    Q_OBJECT

    const Vec2 goal_m{100, 0};

private slots:
    void isNotStuckWhileItComesNearer() {
        StuckWatch watch;
        for (int i = 0; i < 80; ++i)
            watch.update(Seconds(i), {1.1 * i, 0}, goal_m, true);
        QVERIFY(watch.withoutProgress() <= Seconds(1.0));
        QVERIFY(watch.hindered() <= Seconds(1.0));
    }

    void countsTimeWithoutProgress() {
        StuckWatch watch;
        for (int i = 0; i <= 30; ++i)
            watch.update(Seconds(i), {std::sin(i) * 0.4, 0}, goal_m, false);
        QCOMPARE(watch.withoutProgress(), Seconds(30.0));
        QCOMPARE(watch.hindered(), Seconds(0.0));
    }

    void timeThatItWaitsAsToldIsNotCounted() {
        StuckWatch watch;
        watch.update(Seconds(0), {0, 0}, goal_m, true);
        watch.update(Seconds(5), {0, 0}, goal_m, true);
        for (int i = 6; i <= 600; ++i)
            watch.wait(Seconds(i));
        watch.update(Seconds(601), {0, 0}, goal_m, true);
        QCOMPARE(watch.withoutProgress(), Seconds(6.0));
        QCOMPARE(watch.hindered(), Seconds(6.0));
    }

    void countsHinderedTimeApart() {
        StuckWatch watch;
        for (int i = 0; i <= 30; ++i)
            watch.update(Seconds(i), {0, 0}, goal_m, i > 20);
        QCOMPARE(watch.hindered(), Seconds(10.0));
        watch.clearHindered();
        QCOMPARE(watch.hindered(), Seconds(0.0));
        QCOMPARE(watch.withoutProgress(), Seconds(30.0)); // climbing over it is no progress yet
    }

    void startsAnewWithANewGoal() {
        StuckWatch watch;
        for (int i = 0; i <= 30; ++i)
            watch.update(Seconds(i), {0, 0}, goal_m, true);
        watch.update(Seconds(31), {0, 0}, {0, 50}, true);
        QCOMPARE(watch.withoutProgress(), Seconds(0.0));
        QCOMPARE(watch.hindered(), Seconds(0.0));
    }

    void doesNotTakeADetourForProgress() {
        StuckWatch watch;
        watch.update(Seconds(0), {10, 0}, goal_m, true);
        for (int i = 1; i <= 20; ++i)
            watch.update(Seconds(i), {10.0 - i, 0}, goal_m, true);
        for (int i = 21; i <= 40; ++i)
            watch.update(Seconds(i), {-10.0 + (i - 20), 0}, goal_m, true);
        QCOMPARE(watch.withoutProgress(), Seconds(40.0));
    }
};

USAR_TEST(tst_StuckWatch)

} // namespace tst_stuck_watch

#include "tst_stuck_watch.moc"
