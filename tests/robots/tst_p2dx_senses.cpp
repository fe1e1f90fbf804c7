#include <limits>

#include <QObject>
#include <QTest>

#include "robots/p2dx/surroundings.h"
#include "robots/p2dx/track.h"
#include "tests/suite/suite.h"

namespace tst_p2dx_senses {

using namespace usar;
using namespace usar::p2dx;

namespace {

/// 180 beams, from right to left; each third reads the same everywhere.
protocol::RangeScan thirds(double right_m, double ahead_m, double left_m) {
    protocol::RangeScan scan{{}, "Scanner1", pi / 179.0, pi, {}};
    for (const double range_m : {right_m, ahead_m, left_m})
        scan.ranges_m.insert(scan.ranges_m.end(), 60, range_m);
    return scan;
}

Surroundings around(const protocol::RangeScan& scan, const std::vector<protocol::NamedRange>& sonars = {},
                    const Fence& fence = {}) {
    return look(scan, sonars, fence, {});
}

/// Drives straight on from the track's place in steps of 0.1 m.
struct Drive {
    Track track;
    Pose ins;
    Seconds now{0.0};

    void go(int steps, double rise_m = 0.0, Motion motion = Motion::Straight) {
        for (int i = 0; i < steps; ++i) {
            now += Seconds(0.2);
            if (motion != Motion::Standing)
                ins.position_m += Vec3(0.1 * std::cos(ins.yaw_rad), 0.1 * std::sin(ins.yaw_rad), rise_m);
            track.update(now, ins, motion);
        }
    }
};

bool near(double value, double expected) {
    return std::abs(value - expected) < 1e-9;
}

} // namespace

class tst_P2dxSenses : public QObject {
    Q_OBJECT

private slots:
    void theMostOpenThirdHasTheGreatestMean_data() {
        QTest::addColumn<double>("right_m");
        QTest::addColumn<double>("ahead_m");
        QTest::addColumn<double>("left_m");
        QTest::addColumn<int>("third");
        QTest::newRow("left") << 2.0 << 3.0 << 4.0 << int(Third::Left);
        QTest::newRow("ahead") << 2.0 << 4.0 << 3.0 << int(Third::Ahead);
        QTest::newRow("right") << 4.0 << 2.0 << 3.0 << int(Third::Right);
        QTest::newRow("a tie goes to ahead") << 4.0 << 4.0 << 4.0 << int(Third::Ahead);
        QTest::newRow("then to the left") << 4.0 << 3.0 << 4.0 << int(Third::Left);
    }
    void theMostOpenThirdHasTheGreatestMean() {
        QFETCH(double, right_m);
        QFETCH(double, ahead_m);
        QFETCH(double, left_m);
        QFETCH(int, third);
        const Surroundings seen = around(thirds(right_m, ahead_m, left_m));
        QCOMPARE(int(seen.mostOpen()), third);
        QVERIFY(near(seen.meanOf(Third::Left), left_m));
    }

    void beamsWithoutANumberCountForNothing() {
        protocol::RangeScan scan = thirds(2.0, 3.0, 4.0);
        scan.ranges_m[90] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(near(around(scan).meanOf(Third::Ahead), 3.0));
        scan.ranges_m.clear();
        QCOMPARE(around(scan).ahead_m, Surroundings::far_m);
    }

    void onlyTheStripAheadIsInTheWay() {
        protocol::RangeScan scan = thirds(20.0, 20.0, 20.0);
        scan.ranges_m[150] = 0.4; // 60 degrees to the left: 0.35 m aside
        QCOMPARE(around(scan).ahead_m > 10.0, true);
        QVERIFY(near(around(scan).left_m, 0.4));
        scan.ranges_m[100] = 0.5; // 10 degrees
        QVERIFY(std::abs(around(scan).ahead_m - 0.49) < 0.01);
    }

    void frontSonarsHearLowThings() {
        const Surroundings heard =
            around(thirds(20.0, 20.0, 20.0), {{"F1", 0.5}, {"F4", 0.7}, {"F6", 0.4}, {"X", 0.1}});
        QCOMPARE(heard.low_ahead_m, 0.4);
        QCOMPARE(around(thirds(20.0, 20.0, 20.0), {{"F2", 0.4}, {"F8", 0.1}}).low_ahead_m, 0.5);
        QCOMPARE(heard.left_m, 0.5);
        QCOMPARE(heard.right_m, 0.4);
        QVERIFY(heard.betterToTheLeft());
    }

    void whereNoSideIsNearerTheMoreOpenOneIsBetter() {
        protocol::RangeScan scan = thirds(8.0, 2.0, 4.0);
        scan.ranges_m[60] = 2.0;
        scan.ranges_m[120] = 2.1;
        QVERIFY(!around(scan).betterToTheLeft());
    }

    void theFenceCutsBeams_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("yaw_deg");
        QTest::addColumn<double>("distance_m");
        QTest::newRow("ahead") << 0.0 << 0.0 << 4.0;
        QTest::newRow("behind") << 1.0 << 180.0 << 5.0;
        QTest::newRow("to the side") << 0.0 << 90.0 << 3.0;
        QTest::newRow("from outside, outward") << 5.0 << 0.0 << 0.0;
        QTest::newRow("from outside, inward") << 5.0 << 180.0 << 9.0;
    }
    void theFenceCutsBeams() {
        QFETCH(double, x_m);
        QFETCH(double, yaw_deg);
        QFETCH(double, distance_m);
        const Fence fence{{{-4.0, -3.0}, {4.0, 3.0}}, {x_m, 0.0}, radians(yaw_deg)};
        QVERIFY(near(fence.distance_m(0.0), distance_m));
        QCOMPARE(Fence{}.distance_m(0.0), Surroundings::far_m);
    }

    void knowsTheStraightWayBehindIt() {
        Drive drive;
        drive.go(6);
        QVERIFY(near(drive.track.wayBehind_m(), 0.5));
        drive.ins.yaw_rad = 0.5;
        drive.go(3, 0.0, Motion::Curve);
        QVERIFY(near(drive.track.wayBehind_m(), 0.2)); // before the bend it was another way
        drive.track.leaveWay();
        QCOMPARE(drive.track.wayBehind_m(), 0.0);
        QVERIFY(near(drive.track.distance_m(), 0.8));
    }

    void feelsTheSlopeInItsSteps() {
        Drive drive;
        drive.go(5);
        QVERIFY(near(drive.track.descent_rad(), 0.0));
        drive.ins.pitch_rad = 0.3; // the INS's attitude is not believed
        drive.go(5, -0.1);
        QVERIFY(near(drive.track.descent_rad(), radians(45.0)));
        drive.go(5, 0.1);
        QVERIFY(near(drive.track.descent_rad(), radians(-45.0)));
    }

    void drawsItsYawTowardTheCourse() {
        Track track;
        Pose ins; // says 0 while it moves to the upper left
        ins.yaw_rad = 0.3;
        for (int i = 0; i < 200; ++i) {
            ins.position_m.x() += 0.1;
            track.update(Seconds(0.2 * i), ins, Motion::Straight);
        }
        QVERIFY(std::abs(track.base_in_map().yaw_rad) < 0.01);
    }

    void knowsHowFarItGot() {
        Drive drive;
        drive.go(50);
        QCOMPARE(drive.track.progress_m(Seconds(20.0)), Track::unknown_m);
        QVERIFY(std::abs(drive.track.progress_m(Seconds(4.0)) - 2.0) < 0.11);
        drive.go(100, 0.0, Motion::Standing);
        QVERIFY(near(drive.track.progress_m(Seconds(10.0)), 0.0));
        drive.track.forgetPlaces();
        QCOMPARE(drive.track.progress_m(Seconds(10.0)), Track::unknown_m);
    }
};

USAR_TEST(tst_P2dxSenses)

} // namespace tst_p2dx_senses

#include "tst_p2dx_senses.moc"
