#include <cmath>
#include <vector>

#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/flight/reading_checks.h"
#include "tests/suite/suite.h"

namespace tst_reading_checks {

using namespace usar;
using namespace usar::airrobot;

class tst_ReadingChecks : public QObject {
    Q_OBJECT

    static Pose at(double x_m, double z_m = 6.0, double roll_rad = 0.0) { return {Vec3(x_m, 0, z_m), roll_rad, 0, 0}; }

    static protocol::RangeScan scanOf(std::vector<double> ranges_m, double fov_rad = pi,
                                      double resolution_rad = 0.0174) {
        return {std::nullopt, "Scanner1", resolution_rad, fov_rad, std::move(ranges_m)};
    }

private slots:
    void believesALeapOnlyAtTheThirdTime_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("roll_rad");
        QTest::newRow("of the place") << 12.0 << 0.0;
        QTest::newRow("of the attitude") << 1.0 << 0.85;
    }
    void believesALeapOnlyAtTheThirdTime() {
        QFETCH(double, x_m);
        QFETCH(double, roll_rad);
        PoseCheck check;
        QVERIFY(check.believes(Seconds(10.0), at(1.0), {}));
        QVERIFY(!check.believes(Seconds(10.2), at(x_m, 6.0, roll_rad), {}));
        QCOMPARE(check.leanLeapt(), roll_rad > 0.0);
        QVERIFY(check.believes(Seconds(10.4), at(1.1), {})); // It was a damaged line.
        QVERIFY(!check.leanLeapt());
        QVERIFY(!check.believes(Seconds(10.6), at(x_m, 6.0, roll_rad), {}));
        QVERIFY(!check.believes(Seconds(10.8), at(x_m, 6.0, roll_rad), {}));
        QVERIFY(check.believes(Seconds(11.0), at(x_m, 6.0, roll_rad), {}));
        QVERIFY(!check.leanLeapt());
        check.forget();
        QVERIFY(check.believes(Seconds(11.2), at(0.0), {}));
    }

    void aPoseThatRepeatsItselfHangs_data() {
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<double>("after_s");
        QTest::newRow("while it is to fly") << 1.0 << 0.0 << 0.2;
        QTest::newRow("while it is to climb") << 0.0 << 0.5 << 3.0;
        QTest::newRow("while it is to sink") << 0.0 << -0.5 << 1.0;
        QTest::newRow("while it is to stay") << 0.0 << 0.0 << 1e9;
    }
    void aPoseThatRepeatsItselfHangs() {
        QFETCH(double, speed_m_s);
        QFETCH(double, climb_m_s);
        QFETCH(double, after_s);
        PoseCheck check;
        for (int tick = 0; tick < 50; ++tick) {
            const double since_s = 0.2 * tick;
            QCOMPARE(check.believes(Seconds(10.0 + since_s), at(1.0), {speed_m_s, climb_m_s}),
                     since_s < after_s - 1e-6);
        }
    }

    // It has pressed against a roof for longer than a descent may take to begin.
    void aDescentAfterAClimbHasTimeToBegin() {
        PoseCheck check;
        double now_s = 10.0;
        for (int tick = 0; tick < 10; ++tick)
            QVERIFY(check.believes(Seconds(now_s += 0.2), at(1.0), {0.0, 0.5}));
        for (int tick = 0; tick < 5; ++tick)
            QVERIFY(check.believes(Seconds(now_s += 0.2), at(1.0), {0.0, -0.3}));
        QVERIFY(!check.believes(Seconds(now_s + 0.4), at(1.0), {0.0, -0.3}));
    }

    // The robot stops then, and that must not make it believe the pose again.
    void damagedLinesDoNotWakeASensorThatHangs() {
        PoseCheck check;
        const Told flies{1.0, 0.0};
        check.believes(Seconds(10.0), at(1.0), flies);
        QVERIFY(!check.believes(Seconds(10.2), at(1.0), flies));
        for (int tick = 1; tick < 100; ++tick) {
            const bool damaged = tick % 7 == 0 || tick % 7 == 1;
            QVERIFY(!check.believes(Seconds(10.2 + 0.2 * tick), at(damaged ? 1.01 * tick : 1.0), {}));
        }
    }

    void aSensorThatHungIsBelievedAgainAfterThreeOthers() {
        PoseCheck check;
        check.believes(Seconds(10.0), at(1.0), {1.0, 0.0});
        QVERIFY(!check.believes(Seconds(10.2), at(1.0), {1.0, 0.0}));
        QVERIFY(!check.believes(Seconds(12.0), at(1.5), {}));
        QVERIFY(!check.believes(Seconds(12.2), at(1.6), {}));
        QVERIFY(check.believes(Seconds(12.4), at(1.6), {}));
        QVERIFY(check.believes(Seconds(12.6), at(1.6), {})); // It may well stand there.
        QVERIFY(!check.believes(Seconds(12.8), at(1.0), {}));
    }

    void aBeamThatStandsOutIsBelievedTheSecondTime_data() {
        QTest::addColumn<double>("range_m");
        QTest::addColumn<int>("beam_before");
        QTest::addColumn<bool>("believed");
        QTest::newRow("like its neighbors") << 6.4 << -1 << true;
        QTest::newRow("near, alone") << 0.7 << -1 << false;
        QTest::newRow("far, alone") << 19.0 << -1 << false;
        QTest::newRow("a mast that was there before") << 2.5 << 11 << true;
        QTest::newRow("something else was there before") << 2.5 << 17 << false;
    }
    void aBeamThatStandsOutIsBelievedTheSecondTime() {
        QFETCH(double, range_m);
        QFETCH(int, beam_before);
        QFETCH(bool, believed);
        ScanCheck check;
        std::vector<double> ranges_m(20, 6.0);
        if (beam_before >= 0)
            ranges_m[static_cast<std::size_t>(beam_before)] = range_m;
        check.believed(scanOf(ranges_m));
        ranges_m.assign(20, 6.0);
        ranges_m[10] = range_m;
        const std::vector<double> result_m = check.believed(scanOf(ranges_m));
        QCOMPARE(result_m.size(), std::size_t(20));
        for (std::size_t i = 0; i < result_m.size(); ++i)
            QCOMPARE(std::isnan(result_m[i]), i == 10 && !believed);
    }

    void aScanWithAnotherGeometryIsLeftOutUntilItIsToldThreeTimes_data() {
        QTest::addColumn<double>("fov_rad");
        QTest::addColumn<double>("resolution_rad");
        QTest::addColumn<bool>("left_out");
        QTest::newRow("as before") << pi << 0.0174 << false;
        QTest::newRow("a digit of the angle is lost") << 0.1415 << 0.0174 << true;
        QTest::newRow("a digit of the step is lost") << pi << 0.017 << true;
    }
    void aScanWithAnotherGeometryIsLeftOutUntilItIsToldThreeTimes() {
        QFETCH(double, fov_rad);
        QFETCH(double, resolution_rad);
        QFETCH(bool, left_out);
        ScanCheck check;
        const std::vector<double> ranges_m(20, 6.0);
        QVERIFY(!check.believed(scanOf(ranges_m)).empty());
        QCOMPARE(check.believed(scanOf(ranges_m, fov_rad, resolution_rad)).empty(), left_out);
        QVERIFY(!check.believed(scanOf(ranges_m)).empty());
        check.believed(scanOf(ranges_m, fov_rad, resolution_rad));
        QCOMPARE(check.believed(scanOf(ranges_m, fov_rad, resolution_rad)).empty(), left_out);
        QVERIFY(!check.believed(scanOf(ranges_m, fov_rad, resolution_rad)).empty());
    }

    void aSonarThatJumpsIsBelievedTheSecondTime_data() {
        QTest::addColumn<std::vector<double>>("told_m");
        QTest::addColumn<double>("believed_m");
        QTest::newRow("comes nearer") << std::vector<double>{3.0, 2.6} << 2.6;
        QTest::newRow("a lost digit") << std::vector<double>{3.5, 0.5} << 3.5;
        QTest::newRow("a lost digit, and then as before") << std::vector<double>{3.5, 0.5, 3.4} << 3.4;
        QTest::newRow("a lost point") << std::vector<double>{1.5, 15204.0} << 1.5;
        QTest::newRow("a trunk comes into view") << std::vector<double>{5.0, 2.0, 1.9} << 1.9;
        QTest::newRow("a ledge that it nears fast") << std::vector<double>{3.1, 1.8, 0.7} << 0.7;
        QTest::newRow("two damaged ones, near and far") << std::vector<double>{3.1, 0.7, 13.1} << 3.1;
    }
    void aSonarThatJumpsIsBelievedTheSecondTime() {
        QFETCH(std::vector<double>, told_m);
        QFETCH(double, believed_m);
        SonarCheck check;
        double last_m = 0.0;
        for (const double range_m : told_m) {
            last_m = check.believed_m("M0", range_m, range_m < 5.0, {}).value();
            QCOMPARE(check.believed_m("R4", 5.0, false, {}), 5.0); // Others have nothing to do with it.
        }
        QCOMPARE(last_m, believed_m);
    }

    /// As a robot rises to a ledge, several sonars hear it at once (survey 156983).
    void aJumpThatTwoSonarsHearIsBelievedAtOnce_data() {
        QTest::addColumn<double>("first_m");
        QTest::addColumn<double>("second_m");
        QTest::addColumn<bool>("ticks_between");
        QTest::addColumn<double>("believed_m");
        QTest::newRow("a ledge") << 2.05 << 1.8 << false << 1.8;
        QTest::newRow("ranges that differ") << 2.05 << 0.7 << false << 3.1;
        QTest::newRow("one after the other") << 2.05 << 1.8 << true << 3.1;
        QTest::newRow("both are farther") << 4.5 << 4.4 << false << 3.1;
    }
    void aJumpThatTwoSonarsHearIsBelievedAtOnce() {
        QFETCH(double, first_m);
        QFETCH(double, second_m);
        QFETCH(bool, ticks_between);
        QFETCH(double, believed_m);
        SonarCheck check;
        double now_s = 10.0;
        check.begin(Seconds(now_s += 0.2), true);
        QVERIFY(check.believed_m("L1", 3.1, true, {}) && check.believed_m("M0", 3.1, true, {}));
        check.begin(Seconds(now_s += 0.2), true);
        QCOMPARE(check.believed_m("L1", first_m, true, {}), std::optional(3.1));
        if (ticks_between)
            check.begin(Seconds(now_s += 0.2), true);
        QCOMPARE(check.believed_m("M0", second_m, true, {}), std::optional(believed_m));
    }

    /// The tip of a tree is so thin that a single ray meets it (survey 159552).
    void whatOneRayMeetsCloseByIsAGlimpse_data() {
        QTest::addColumn<double>("range_m");
        QTest::addColumn<bool>("high");
        QTest::addColumn<bool>("glimpsed");
        QTest::newRow("close by") << 0.8 << true << true;
        QTest::newRow("farther off") << 2.5 << true << false;
        QTest::newRow("close to the ground") << 0.8 << false << false;
    }
    void whatOneRayMeetsCloseByIsAGlimpse() {
        QFETCH(double, range_m);
        QFETCH(bool, high);
        QFETCH(bool, glimpsed);
        SonarCheck check;
        double now_s = 10.0;
        int glimpses = 0;
        for (int tick = 0; tick < 100; ++tick) { // In the end, it is a link that damages lines.
            check.begin(Seconds(now_s += 1.0), high);
            const double told_m = tick % 10 == 5 ? range_m : 5.0;
            QCOMPARE(check.believed_m("M0", told_m, told_m < 5.0, {}), std::optional(5.0));
            glimpses += check.glimpsed();
            QVERIFY(!check.glimpsed() || told_m < 5.0);
        }
        QCOMPARE(glimpses, glimpsed ? 4 : 0);
        check.begin(Seconds(now_s += 200.0), high);
        check.believed_m("M0", range_m, true, {});
        QCOMPARE(check.glimpsed(), glimpsed);
    }

    void aSonarThatRepeatsItsEchoHangs_data() {
        QTest::addColumn<double>("range_m");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<bool>("hangs");
        QTest::newRow("an echo under way") << 3.1415 << 1.0 << true;
        QTest::newRow("an echo at rest") << 3.1415 << 0.0 << false;
        QTest::newRow("no echo") << 5.0 << 1.0 << false;
        QTest::newRow("a wall that it touches") << 0.2 << 1.0 << false;
    }
    void aSonarThatRepeatsItsEchoHangs() {
        QFETCH(double, range_m);
        QFETCH(double, speed_m_s);
        QFETCH(bool, hangs);
        SonarCheck check;
        for (int tick = 0; tick < 20; ++tick)
            QCOMPARE(check.believed_m("M0", range_m, range_m < 5.0, {speed_m_s, 0.0}).has_value(), !hangs || tick < 5);
        QVERIFY(check.believed_m("M0", range_m - 0.01, true, {speed_m_s, 0.0}));
    }
};

USAR_TEST(tst_ReadingChecks)

} // namespace tst_reading_checks

#include "tst_reading_checks.moc"
