#include <QTest>

#include "core/base/random.h"
#include "core/protocol/wire_frame.h"
#include "tests/suite/suite.h"

namespace tst_wire_frame {

using namespace usar;
using protocol::acrossWire;

namespace {

Pose anyPose(Random& random) {
    return {{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, -50, 50)},
            uniform(random, -pi, pi),
            uniform(random, -1.5, 1.5),
            uniform(random, -pi, pi)};
}

} // namespace

class tst_WireFrame : public QObject {
    Q_OBJECT
private slots:
    void crossingTwiceIsNothing();
    void rightAndDownBecomeLeftAndUp();
    void clockwiseBecomesCounterClockwise();
    void aRaisedNoseStaysRaised();
    void rollStays();
    void crossingIsHalfATurnAboutX();
};

void tst_WireFrame::crossingTwiceIsNothing() {
    Random random = seeded(13, 1);
    for (int i = 0; i < 1000; ++i) {
        const Pose pose = anyPose(random);
        QVERIFY(acrossWire(acrossWire(pose)) == pose);
    }
    QCOMPARE(acrossWire(acrossWire(Pose{.yaw_rad = pi})).yaw_rad, pi);
}

void tst_WireFrame::rightAndDownBecomeLeftAndUp() {
    QVERIFY(acrossWire(Vec3(1, 2, 3)) == Vec3(1, -2, -3));
    QCOMPARE(acrossWire(0.5), -0.5);
}

void tst_WireFrame::clockwiseBecomesCounterClockwise() {
    // A quarter turn clockwise looks to the wire's +y, which is the right: our -y.
    const Pose turned = acrossWire(Pose{.yaw_rad = pi / 2});
    QVERIFY((turned * Vec3(1, 0, 0) - Vec3(0, -1, 0)).norm() < 1e-12);
}

void tst_WireFrame::aRaisedNoseStaysRaised() {
    const Pose raised = acrossWire(Pose{.pitch_rad = 0.3});
    QVERIFY((raised * Vec3(1, 0, 0)).z() > 0.2);
}

void tst_WireFrame::rollStays() {
    // Positive roll lowers the right side in both frames.
    const Pose rolled = acrossWire(Pose{.roll_rad = 0.3});
    QCOMPARE(rolled.roll_rad, 0.3);
    QVERIFY((rolled * Vec3(0, -1, 0)).z() < -0.2);
}

void tst_WireFrame::crossingIsHalfATurnAboutX() {
    Random random = seeded(14, 1);
    const Pose half_turn{.roll_rad = pi};
    for (int i = 0; i < 200; ++i) {
        const Pose pose = anyPose(random);
        const Pose conjugated = half_turn * pose * inverse(half_turn);
        const Pose crossed = acrossWire(pose);
        QVERIFY((conjugated.position_m - crossed.position_m).norm() < 1e-9);
        QVERIFY(conjugated.rotation().angularDistance(crossed.rotation()) < 1e-7);
    }
}

USAR_TEST(tst_WireFrame)

} // namespace tst_wire_frame

#include "tst_wire_frame.moc"
