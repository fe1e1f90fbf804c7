#include <QTest>

#include "core/base/geometry.h"
#include "core/base/random.h"
#include "tests/suite/suite.h"

namespace tst_geometry {

using namespace usar;

namespace {

Pose anyPose(Random& random) {
    return {{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, -50, 50)},
            uniform(random, -pi, pi),
            uniform(random, -1.5, 1.5), // away from the poles, where roll and yaw are one
            uniform(random, -pi, pi)};
}

bool near(const Pose& a, const Pose& b) {
    return (a.position_m - b.position_m).norm() < 1e-9 && a.rotation().angularDistance(b.rotation()) < 1e-7;
}

} // namespace

class tst_Geometry : public QObject {
    Q_OBJECT
private slots:
    void anglesWrapIntoOneTurn_data();
    void anglesWrapIntoOneTurn();
    void posesMultiplyLikeDominoes();
    void aPoseTimesItsInverseIsNothing();
    void yawTurnsForwardToTheLeft();
    void pitchIsRightHandedSoPositiveLooksDown();
    void rectanglesKnowWhatTheyHold();
};

void tst_Geometry::anglesWrapIntoOneTurn_data() {
    QTest::addColumn<double>("angle_rad");
    QTest::addColumn<double>("expected_rad");
    QTest::newRow("inside stays") << 1.0 << 1.0;
    QTest::newRow("half a turn is positive") << -pi << pi;
    QTest::newRow("one turn is nothing") << 2 * pi << 0.0;
    QTest::newRow("UT2004's tiny negative roll") << 6.28 << 6.28 - 2 * pi;
    QTest::newRow("UDK's unwrapped theta") << -8.6119 << -8.6119 + 2 * pi;
}

void tst_Geometry::anglesWrapIntoOneTurn() {
    QFETCH(double, angle_rad);
    QFETCH(double, expected_rad);
    QVERIFY(std::abs(normalizedAngle(angle_rad) - expected_rad) < 1e-12);
}

void tst_Geometry::posesMultiplyLikeDominoes() {
    Random random = seeded(1, 1);
    for (int i = 0; i < 200; ++i) {
        const Pose base_in_map = anyPose(random);
        const Pose sonar_in_base = anyPose(random);
        const Vec3 point_in_sonar_m = anyPose(random).position_m;
        const Vec3 by_product = (base_in_map * sonar_in_base) * point_in_sonar_m;
        const Vec3 by_steps = base_in_map * (sonar_in_base * point_in_sonar_m);
        QVERIFY((by_product - by_steps).norm() < 1e-6);
    }
}

void tst_Geometry::aPoseTimesItsInverseIsNothing() {
    Random random = seeded(2, 1);
    for (int i = 0; i < 200; ++i) {
        const Pose pose = anyPose(random);
        QVERIFY(near(pose * inverse(pose), Pose{}));
        QVERIFY(near(Pose::from(pose.isometry()), pose));
    }
}

void tst_Geometry::yawTurnsForwardToTheLeft() {
    const Vec3 ahead = Pose{.yaw_rad = pi / 2} * Vec3(1, 0, 0);
    QVERIFY((ahead - Vec3(0, 1, 0)).norm() < 1e-12);
}

void tst_Geometry::pitchIsRightHandedSoPositiveLooksDown() {
    const Vec3 ahead = Pose{.pitch_rad = pi / 2} * Vec3(1, 0, 0);
    QVERIFY((ahead - Vec3(0, 0, -1)).norm() < 1e-12);
}

void tst_Geometry::rectanglesKnowWhatTheyHold() {
    const Rectangle area{{0, 0}, {4, 2}};
    QVERIFY(area.contains(Vec2(4, 2)));
    QVERIFY(!area.contains(Vec2(4.01, 1)));
    QCOMPARE(area.area_m2(), 8.0);
    QVERIFY((Rectangle{{0, 0}, {0, 5}}.empty()));
    QVERIFY((Rectangle{{0, 0}, {-1, 5}}.empty()));
    QCOMPARE((Rectangle{{1, 1}, {0, 0}}.area_m2()), 0.0);
}

USAR_TEST(tst_Geometry)

} // namespace tst_geometry

#include "tst_geometry.moc"
