// The angles of a leg, and the place of its foot that follows from them.
#include <cmath>

#include <QTest>

#include "core/agent/leg_kinematics.h"
#include "tests/suite/suite.h"

namespace tst_leg_kinematics {

using namespace usar::agent;

class tst_LegKinematics : public QObject {
    Q_OBJECT
private slots:
    void putsTheFootThere_data();
    void putsTheFootThere();
    void pointsAtWhatIsTooFarAway_data();
    void pointsAtWhatIsTooFarAway();
};

void tst_LegKinematics::putsTheFootThere_data() {
    QTest::addColumn<double>("thigh_m");
    QTest::addColumn<double>("shin_m");
    QTest::addColumn<double>("forward_m");
    QTest::addColumn<double>("down_m");
    QTest::newRow("straight down") << ers_leg.thigh_m << ers_leg.shin_m << 0.0 << ers_leg.thigh_m + ers_leg.shin_m;
    QTest::newRow("standing") << ers_leg.thigh_m << ers_leg.shin_m << 0.015 << 0.11;
    QTest::newRow("in front") << ers_leg.thigh_m << ers_leg.shin_m << 0.05 << 0.11;
    QTest::newRow("behind") << ers_leg.thigh_m << ers_leg.shin_m << -0.04 << 0.1;
    QTest::newRow("a larger leg") << 0.3 << 0.2 << 0.1 << 0.4;
}

void tst_LegKinematics::putsTheFootThere() {
    QFETCH(double, thigh_m);
    QFETCH(double, shin_m);
    QFETCH(double, forward_m);
    QFETCH(double, down_m);
    const LegAngles angles = legAngles({thigh_m, shin_m}, forward_m, down_m);
    const double shin_rad = angles.hip_rad - angles.knee_rad;
    const double foot_forward_m = thigh_m * std::sin(angles.hip_rad) + shin_m * std::sin(shin_rad);
    const double foot_down_m = thigh_m * std::cos(angles.hip_rad) + shin_m * std::cos(shin_rad);
    QVERIFY(std::abs(foot_forward_m - forward_m) < 1e-6);
    QVERIFY(std::abs(foot_down_m - down_m) < 1e-6);
    QVERIFY(angles.knee_rad >= 0.0);
}

void tst_LegKinematics::pointsAtWhatIsTooFarAway_data() {
    QTest::addColumn<double>("forward_m");
    QTest::addColumn<double>("down_m");
    QTest::newRow("below") << 0.0 << 0.5;
    QTest::newRow("ahead") << 0.5 << 0.0;
    QTest::newRow("behind and below") << -0.3 << 0.3;
}

void tst_LegKinematics::pointsAtWhatIsTooFarAway() {
    QFETCH(double, forward_m);
    QFETCH(double, down_m);
    const LegAngles angles = legAngles(ers_leg, forward_m, down_m);
    QCOMPARE(angles.knee_rad, 0.0);
    QCOMPARE(angles.hip_rad, std::atan2(forward_m, down_m));
}

USAR_TEST(tst_LegKinematics)

} // namespace tst_leg_kinematics

#include "tst_leg_kinematics.moc"
