#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/drives/ackermann_drive.h"
#include "tests/sim/driven_robot.h"
#include "tests/suite/suite.h"

namespace tst_ackermann_drive {

using namespace usar;
using namespace usar::sim;

namespace {

const std::string robots = USAR_SOURCE_DIR "/resources/robots";
constexpr double base_m = 2.6;
constexpr double track_m = 1.5;
constexpr double radius_m = 0.32;

} // namespace

class tst_AckermannDrive : public QObject {
    Q_OBJECT

private slots:
    void innerAndOuterWheelsPointAtOneCenter_data() {
        QTest::addColumn<double>("steer_rad");
        QTest::newRow("left") << 0.4;
        QTest::newRow("right") << -0.4;
        QTest::newRow("a little") << 0.05;
        QTest::newRow("straight") << 0.0;
    }
    void innerAndOuterWheelsPointAtOneCenter() {
        QFETCH(double, steer_rad);
        DrivenRobot car(flatWorld(), robots, "Sedan", 0.0, 0.0);
        QVERIFY(car.drive->obey(protocol::AckermannDrive{1.0, steer_rad}));
        car.run(Seconds{3.0});
        const double cot = steer_rad == 0.0 ? 1e12 : 1.0 / std::tan(steer_rad);
        const double left_rad = std::atan(1.0 / (cot - track_m / 2.0 / base_m));
        const double right_rad = std::atan(1.0 / (cot + track_m / 2.0 / base_m));
        QVERIFY(std::abs(car.joint("FrontLeftSteer").position - left_rad) < 0.01);
        QVERIFY(std::abs(car.joint("FrontRightSteer").position - right_rad) < 0.01);
        protocol::RobotState state;
        car.drive->addState(state);
        QVERIFY(std::abs(*state.front_steer_rad - (left_rad + right_rad) / 2.0) < 0.01);
        QCOMPARE(*state.rear_steer_rad, 0.0);
    }

    void turnsOnABicyclesCircle() {
        DrivenRobot car(flatWorld(), robots, "Sedan", 0.0, -8.0);
        car.drive->obey(protocol::AckermannDrive{9.0, 0.35});
        car.run(Seconds{5.0});
        const double circle_m = base_m / std::tan(0.35); // of the rear axle's middle
        const double rate_rad_s = 9.0 * radius_m / circle_m;
        double turned_rad = 0.0;
        double last_rad = car.pose().yaw_rad;
        Vec3 low_m = car.position_m();
        Vec3 high_m = low_m;
        const Seconds round{2.0 * pi / rate_rad_s};
        car.run(round, [&] {
            const Pose now = car.pose();
            turned_rad += normalizedAngle(now.yaw_rad - last_rad);
            last_rad = now.yaw_rad;
            low_m = low_m.cwiseMin(now.position_m);
            high_m = high_m.cwiseMax(now.position_m);
        });
        const double middle_m = std::hypot(circle_m, base_m / 2.0);
        QVERIFY2(std::abs(turned_rad / (2.0 * pi) - 1.0) < 0.06, qPrintable(QString::number(turned_rad)));
        QVERIFY2(std::abs((high_m - low_m).x() / (2.0 * middle_m) - 1.0) < 0.06,
                 qPrintable(QString::number((high_m - low_m).x() / 2.0)));
    }

    void drivesStraightBothWays() {
        DrivenRobot car(flatWorld(), robots, "Sedan", -10.0, 0.0);
        car.drive->obey(protocol::AckermannDrive{8.0});
        car.run(Seconds{3.0});
        const Vec3 from_m = car.position_m();
        car.run(Seconds{4.0});
        QVERIFY(std::abs((car.position_m() - from_m).x() / (4.0 * 8.0 * radius_m) - 1.0) < 0.03);
        QVERIFY(std::abs((car.position_m() - from_m).y()) < 0.1);
        car.drive->obey(protocol::AckermannDrive{-100.0 / 60.0 * 4.0, std::nullopt, std::nullopt, true});
        car.run(Seconds{4.0});
        QVERIFY(std::abs(car.body.velocity_in_map_m_s().x() + 4.0 * radius_m) < 0.05);
        car.drive->obey(protocol::AckermannDrive{0.0});
        car.run(Seconds{3.0});
        QVERIFY(car.speed_m_s() < 0.01);
        QVERIFY(car.drive->idle());
    }

    void termsComeSinglyAndStayWithinTheLimits() {
        DrivenRobot car(flatWorld(), robots, "Sedan", 0.0, 0.0);
        car.drive->obey(protocol::AckermannDrive{std::nullopt, 0.2});
        car.drive->obey(protocol::AckermannDrive{2.0});
        car.run(Seconds{2.0});
        QVERIFY(car.joint("FrontLeftSteer").position > 0.15);
        QVERIFY(car.speed_m_s() > 0.5);
        car.drive->obey(protocol::AckermannDrive{std::nullopt, 7.0, 7.0});
        car.run(Seconds{2.0});
        QVERIFY(car.joint("FrontLeftSteer").position < 0.63);
        QVERIFY(!car.drive->obey(protocol::SkidDrive{1.0, 1.0}));
    }

    void tellsItsLimits() {
        DrivenRobot car(flatWorld(), robots, "Sedan", 0.0, 0.0);
        std::vector<protocol::Setting> settings;
        car.drive->addSettings(settings);
        QCOMPARE(settings[0], (protocol::Setting{"MaxSpeed", "", 60.0}));
        QCOMPARE(settings[2], (protocol::Setting{"MaxFrontSteer", "", 0.6}));
        QCOMPARE(settings[3], (protocol::Setting{"MaxRearSteer", "", 0.0}));
    }

    void aModelWithoutItsFiguresIsRefused() {
        DrivenRobot car(flatWorld(), robots, "Sedan", 0.0, 0.0);
        RobotModel model = car.model;
        model.drive.numbers.erase("wheel_base");
        QVERIFY(!makeDrive(model, *car.physics, car.body.id(), car.world, false));
        model = car.model;
        model.drive.numbers["steered"] = 9.0;
        QVERIFY(!makeDrive(model, *car.physics, car.body.id(), car.world, false));
    }
};

USAR_TEST(tst_AckermannDrive)

} // namespace tst_ackermann_drive

#include "tst_ackermann_drive.moc"
