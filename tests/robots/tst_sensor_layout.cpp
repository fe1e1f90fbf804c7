#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/flight/sensor_layout.h"
#include "tests/suite/suite.h"

namespace tst_sensor_layout {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::protocol;

class tst_SensorLayout : public QObject {
    Q_OBJECT

private slots:
    void putsNineStockSonarsOnTheRing() {
        const SensorLayout layout = stockLayout();
        QCOMPARE(layout.sonars.size(), std::size_t(9));
        QCOMPARE(layout.sonars.front().name, std::string("L4"));
        QCOMPARE(layout.sonars[4].name, std::string("M0"));
        QVERIFY(std::abs(layout.sonars[4].sonar_in_base.yaw_rad) < 1e-9);
        QVERIFY(layout.sonars.front().sonar_in_base.position_m.y() > 0.4); // left is positive
        for (const SonarMount& sonar : layout.sonars)
            QVERIFY(std::abs(sonar.sonar_in_base.position_m.norm() - 0.5) < 1e-9);
    }

    void pointsTheStockScannerStraightDownAcrossTheTrack() {
        const Pose scanner_in_base = stockLayout().scanner_in_base;
        const Vec3 middle = scanner_in_base.rotation() * Vec3::UnitX();
        const Vec3 left = scanner_in_base.rotation() * Vec3::UnitY();
        QVERIFY((middle - -Vec3::UnitZ()).norm() < 1e-9);
        QVERIFY((left - Vec3::UnitY()).norm() < 1e-9);
    }

    void sortsAnsweredSonarsFromLeftToRight() {
        SensorLayout layout = stockLayout();
        GeometryInfo answer;
        answer.items = {{"F2", {Vec3::Zero(), 0, 0, -0.4}, "HARD"}, {"F1", {Vec3::Zero(), 0, 0, 0.4}, "HARD"}};
        QVERIFY(takeSonarGeometry(layout, answer));
        QCOMPARE(layout.sonars.size(), std::size_t(2));
        QCOMPARE(layout.sonars[0].name, std::string("F1"));
    }

    void keepsTheStockWhenAnAnswerIsBare() {
        SensorLayout layout = stockLayout();
        QVERIFY(!takeSonarGeometry(layout, {}));
        QVERIFY(!takeScannerGeometry(layout, {}));
        QVERIFY(!takeSonarLimits(layout, {}));
        QVERIFY(!takeScannerLimits(layout, {}));
        QVERIFY(!takeRobotLimits(layout, {}));
        QVERIFY(layout == stockLayout());
    }

    void takesLimitsByNameOrForAll_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("two_items");
        QTest::addColumn<double>("l4_m");
        QTest::addColumn<double>("m0_m");
        QTest::newRow("one answer for all") << "Sonar" << false << 8.0 << 8.0;
        QTest::newRow("one of several") << "M0" << true << 5.0 << 8.0;
    }
    void takesLimitsByNameOrForAll() {
        QFETCH(QString, name);
        QFETCH(bool, two_items);
        QFETCH(double, l4_m);
        QFETCH(double, m0_m);
        SensorLayout layout = stockLayout();
        ConfigurationInfo answer{"Sonar", {{name.toStdString(), {{"MaxRange", "8.0", 8.0}}}}};
        if (two_items)
            answer.items.push_back({"R4", {}});
        QVERIFY(takeSonarLimits(layout, answer));
        QCOMPARE(layout.sonars[0].maximum_m, l4_m);
        QCOMPARE(layout.sonars[4].maximum_m, m0_m);
    }

    void takesTheScannersNamePlaceAndReach() {
        SensorLayout layout = stockLayout();
        GeometryInfo geometry;
        geometry.items = {{"Scanner1", {Vec3(0, 0, -0.2), 0, 1.5, 0}, "HARD"}};
        QVERIFY(takeScannerGeometry(layout, geometry));
        QCOMPARE(layout.scanner_name, std::string("Scanner1"));
        QCOMPARE(layout.scanner_in_base.position_m.z(), -0.2);
        QVERIFY(takeScannerLimits(layout, {"RangeScanner", {{"Scanner1", {{"MaxRange", "30", 30.0}}}}}));
        QCOMPARE(layout.scanner_maximum_m, 30.0);
    }

    void ignoresLimitsThatCannotBe_data() {
        QTest::addColumn<double>("value");
        QTest::newRow("zero") << 0.0;
        QTest::newRow("negative") << -2.0;
        QTest::newRow("not a number") << std::nan("");
        QTest::newRow("endless") << std::numeric_limits<double>::infinity();
    }
    void ignoresLimitsThatCannotBe() {
        QFETCH(double, value);
        SensorLayout layout = stockLayout();
        QVERIFY(!takeRobotLimits(layout, {"AerialVehicle", {{"AirRobot", {{"MaxLinearVelocity", "", value}}}}}));
        QCOMPARE(layout.maximum_speed_m_s, 2.0);
    }

    void takesTheRobotsSpeeds() {
        SensorLayout layout = stockLayout();
        QVERIFY(takeRobotLimits(layout, {"AerialVehicle",
                                         {{"AirRobot",
                                           {{"MaxLinearVelocity", "3", 3.0},
                                            {"MaxAltitudeVelocity", "1", 1.0},
                                            {"MaxRotationalVelocity", "0.5", 0.5}}}}}));
        QCOMPARE(layout.maximum_speed_m_s, 3.0);
        QCOMPARE(layout.maximum_climb_m_s, 1.0);
        QCOMPARE(layout.maximum_turn_rad_s, 0.5);
    }
};

USAR_TEST(tst_SensorLayout)

} // namespace tst_sensor_layout

#include "tst_sensor_layout.moc"
