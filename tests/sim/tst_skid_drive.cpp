#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/drives/wheeled_drive.h"
#include "tests/sim/driven_robot.h"
#include "tests/suite/suite.h"

namespace tst_skid_drive {

using namespace usar;
using namespace usar::sim;

namespace {

const std::string robots = USAR_SOURCE_DIR "/resources/robots";

/// What a robot does on the way: turned angle and the box that its base stays in.
struct Track {
    double turned_rad = 0.0;
    Vec3 low_m = Vec3::Constant(1e9);
    Vec3 high_m = Vec3::Constant(-1e9);
    double diameter_m() const { return ((high_m - low_m).x() + (high_m - low_m).y()) / 2.0; }
};

Track follow(DrivenRobot& robot, Seconds duration) {
    Track track;
    double last_rad = robot.pose().yaw_rad;
    robot.run(duration, [&] {
        const Pose now = robot.pose();
        track.turned_rad += normalizedAngle(now.yaw_rad - last_rad);
        last_rad = now.yaw_rad;
        track.low_m = track.low_m.cwiseMin(now.position_m);
        track.high_m = track.high_m.cwiseMax(now.position_m);
    });
    return track;
}

bool near(double value, double expected, double share) {
    const bool is_near = std::abs(value - expected) <= share * std::abs(expected);
    if (!is_near)
        qWarning("%g is not within %g %% of %g", value, share * 100.0, expected);
    return is_near;
}

} // namespace

class tst_SkidDrive : public QObject {
    Q_OBJECT

private slots:
    void drivesStraightAtTheSpinOfItsWheels_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("spin_rad_s");
        QTest::addColumn<double>("radius_m");
        QTest::newRow("two wheels and a caster") << "P2DX" << 5.0 << 0.097;
        QTest::newRow("backwards, so that the caster turns round") << "P2DX" << -4.0 << 0.097;
        QTest::newRow("four wheels") << "P2AT" << 4.0 << 0.13;
    }
    void drivesStraightAtTheSpinOfItsWheels() {
        QFETCH(QString, name);
        QFETCH(double, spin_rad_s);
        QFETCH(double, radius_m);
        DrivenRobot robot(flatWorld(), robots, name.toStdString(), 0.1, 0.13);
        robot.run(Seconds{1.0});
        QVERIFY(robot.drive->obey(protocol::SkidDrive{spin_rad_s, spin_rad_s}));
        robot.run(Seconds{4.0});
        const Vec3 from_m = robot.position_m();
        const double yaw_rad = robot.pose().yaw_rad;
        robot.run(Seconds{5.0});
        const Vec3 way_m = robot.position_m() - from_m;
        QVERIFY(near(way_m.dot(Vec3(std::cos(yaw_rad), std::sin(yaw_rad), 0.0)), 5.0 * spin_rad_s * radius_m, 0.03));
        QVERIFY(std::abs(normalizedAngle(robot.pose().yaw_rad - yaw_rad)) < 0.03);
    }

    void aCircleClosesWithinWhatSlipAllows() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        robot.drive->obey(protocol::SkidDrive{3.0, 6.0});
        robot.run(Seconds{4.0}); // the caster finds its angle
        const double rate_rad_s = 3.0 * 0.097 / 0.337;
        const Vec3 from_m = robot.position_m();
        const Track track = follow(robot, Seconds{2.0 * pi / rate_rad_s});
        QVERIFY(near(track.turned_rad, 2.0 * pi, 0.05));
        QVERIFY(near(track.diameter_m(), 2.0 * 4.5 * 0.097 / rate_rad_s, 0.05));
        QVERIFY((robot.position_m() - from_m).norm() < 0.15);
    }

    void fourWheelsSkidAroundSlowerThanTheyRoll() {
        DrivenRobot robot(flatWorld(), robots, "P2AT", 0.1, 0.13);
        robot.drive->obey(protocol::SkidDrive{-3.0, 3.0});
        robot.run(Seconds{2.0});
        const Vec3 from_m = robot.position_m();
        const Track track = follow(robot, Seconds{5.0});
        const double rolling_rad = 5.0 * 6.0 * 0.13 / 0.4712;
        QVERIFY(track.turned_rad > 0.3 * rolling_rad);
        QVERIFY(track.turned_rad < 1.02 * rolling_rad);
        QVERIFY((robot.position_m() - from_m).norm() < 0.3);
    }

    void standsStillOnASlope_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("yaw_rad");
        QTest::newRow("two wheels, uphill") << "P2DX" << 0.0;
        QTest::newRow("two wheels, across") << "P2DX" << pi / 2.0;
        QTest::newRow("four wheels, uphill") << "P2AT" << 0.0;
        QTest::newRow("four wheels, downhill") << "P2AT" << pi;
    }
    void standsStillOnASlope() {
        QFETCH(QString, name);
        QFETCH(double, yaw_rad);
        DrivenRobot robot(slopeWorld(radians(10.0)), robots, name.toStdString(), 0.1, 0.13, yaw_rad);
        robot.run(Seconds{4.0});
        const Vec3 from_m = robot.position_m();
        robot.run(Seconds{60.0});
        QVERIFY((robot.position_m() - from_m).norm() < 0.01);
        QVERIFY(robot.drive->idle());
    }

    void countsWhatItRunsInto_data() {
        QTest::addColumn<bool>("tree");
        QTest::addColumn<double>("aside_m");
        QTest::addColumn<bool>("hits");
        QTest::newRow("a wall") << false << 0.0 << true;
        QTest::newRow("a tree") << true << 0.0 << true;
        QTest::newRow("the ground alone") << true << 5.0 << false;
    }
    void countsWhatItRunsInto() {
        QFETCH(bool, tree);
        QFETCH(double, aside_m);
        QFETCH(bool, hits);
        World world = flatWorld();
        if (tree)
            world.plants.push_back({{2.5, 0.13 + aside_m, 0.0}, 0.3, 3.0, CrownShape::Sphere, 1.0});
        else
            world.boxes.push_back({Pose{{2.5, 0.0, 0.5}}, {1.0, 4.0, 1.0}});
        DrivenRobot robot(std::move(world), robots, "P2DX", 0.1, 0.13);
        robot.drive->obey(protocol::SkidDrive{4.0, 4.0});
        robot.run(Seconds{3.0});
        QCOMPARE(robot.drive->collisions(), 0);
        robot.run(Seconds{7.0});
        QCOMPARE(robot.drive->collisions() > 0, hits);
        QVERIFY(robot.drive->collisions() < 4); // pressing on is no new collision
    }

    void stopsWithinItsBrakingDistance() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        robot.drive->obey(protocol::SkidDrive{10.0, 10.0});
        robot.run(Seconds{3.0});
        const double speed_m_s = robot.speed_m_s();
        const Vec3 from_m = robot.position_m();
        robot.drive->obey(protocol::SkidDrive{0.0, 0.0});
        QVERIFY(!robot.drive->idle());
        robot.run(Seconds{3.0});
        const double braking_m_s2 = robot.model.drive.numbers.at("acceleration") * 0.097;
        QVERIFY(near((robot.position_m() - from_m).norm(), speed_m_s * speed_m_s / (2.0 * braking_m_s2), 0.1));
        QVERIFY(robot.drive->idle());
        QVERIFY(robot.speed_m_s() < 0.005);
    }

    void percentAreOfTheLargestSpinAndAbsentTermsStay() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        robot.drive->obey(protocol::SkidDrive{50.0, 250.0, true});
        robot.run(Seconds{2.0});
        QVERIFY(near(robot.joint("LeftWheel").velocity, 8.2, 0.02));
        QVERIFY(near(robot.joint("RightWheel").velocity, 16.4, 0.02));
        robot.drive->obey(protocol::SkidDrive{std::nullopt, 4.0});
        robot.run(Seconds{2.0});
        QVERIFY(near(robot.joint("LeftWheel").velocity, 8.2, 0.02));
        QVERIFY(near(robot.joint("RightWheel").velocity, 4.0, 0.02));
    }

    void nonsenseMovesNothing() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        QVERIFY(!robot.drive->obey(protocol::AerialDrive{}));
        QVERIFY(!robot.drive->obey(protocol::MultiDrive{}));
        QVERIFY(!robot.drive->obey(protocol::JointDrive{"NoSuchJoint", protocol::JointOrder::Speed, 3.0}));
        QVERIFY(!robot.drive->obey(protocol::JointDrive{"CasterFork", protocol::JointOrder::Speed, 3.0}));
        robot.drive->obey(protocol::SkidDrive{std::nan(""), std::nan("")});
        robot.run(Seconds{1.0});
        QVERIFY(robot.drive->idle());
        QVERIFY(std::abs(robot.joint("LeftWheel").velocity) < 0.01);
    }

    void aWheelObeysByNameUntilTheDriveIsToldAgain() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        robot.run(Seconds{0.5});
        QVERIFY(robot.drive->obey(protocol::JointDrive{"LeftWheel", protocol::JointOrder::Speed, 2.0}));
        robot.run(Seconds{1.0});
        QVERIFY(!robot.drive->idle());
        QVERIFY(near(robot.joint("LeftWheel").velocity, 2.0, 0.05));
        QVERIFY(std::abs(robot.joint("RightWheel").velocity) < 0.05);
        robot.drive->obey(protocol::SkidDrive{0.0, 0.0});
        robot.run(Seconds{1.0});
        QVERIFY(std::abs(robot.joint("LeftWheel").velocity) < 0.01);
    }

    void anEmptyBatteryLetsItRoll() {
        DrivenRobot robot(slopeWorld(radians(-10.0)), robots, "P2DX", 0.1, 0.13);
        robot.run(Seconds{1.0});
        robot.drive->switchOff();
        QVERIFY(robot.drive->idle());
        robot.run(Seconds{2.0});
        QVERIFY(robot.position_m().x() > 0.3);
    }

    void tellsItsFigures() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        protocol::GeometryInfo geometry;
        robot.drive->addGeometry(geometry);
        QCOMPARE(geometry.wheel_radius_m.value(), 0.097);
        QCOMPARE(geometry.wheel_separation_m.value(), 0.337);
        std::vector<protocol::Setting> settings;
        robot.drive->addSettings(settings);
        QCOMPARE(settings.size(), std::size_t{4});
        QCOMPARE(settings[0], (protocol::Setting{"MaxSpeed", "", 16.4}));
        QCOMPARE(settings[1], (protocol::Setting{"MaxTorque", "", 5.0}));
        QCOMPARE(settings[2], (protocol::Setting{"MaxFrontSteer", "", 0.0}));
        protocol::RobotState state;
        robot.drive->addState(state);
        QCOMPARE(state.front_steer_rad.value(), 0.0);
        QCOMPARE(state.rear_steer_rad.value(), 0.0);
        QVERIFY(state.joints.empty()); // the camera's are its mission package's
    }

    void aModelThatLacksSomethingIsRefused() {
        DrivenRobot robot(flatWorld(), robots, "P2DX", 0.1, 0.13);
        RobotModel model = robot.model;
        model.drive.joints = {"LeftWheel", "RihgtWheel"};
        const auto misspelt = makeDrive(model, *robot.physics, robot.body.id(), robot.world, false);
        QVERIFY(!misspelt);
        QVERIFY(misspelt.error().text().find("RihgtWheel") != std::string::npos);
        model.drive.joints = {"LeftWheel"};
        QVERIFY(!makeDrive(model, *robot.physics, robot.body.id(), robot.world, false));
    }
};

USAR_TEST(tst_SkidDrive)

} // namespace tst_skid_drive

#include "tst_skid_drive.moc"
