#include <algorithm>
#include <vector>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/leg_kinematics.h"
#include "core/sim/drives/driven_joints.h"
#include "tests/sim/driven_robot.h"
#include "tests/suite/suite.h"

namespace tst_leg_drive {

using namespace usar;
using namespace usar::sim;

namespace {

const std::string robots = USAR_SOURCE_DIR "/resources/robots";
constexpr double thigh_m = 0.071;
constexpr double shin_m = 0.072;
constexpr double standing_m = 0.11; ///< from the hips down to the paws
constexpr double forward_m = 0.015; ///< of the paws: the head weighs on the front
constexpr double upright_m = 0.143; ///< as a spawned one stands, its legs straight

/// Targets of one leg whose paw is to be at (x, z) from its hip, x forward.
void put(protocol::MultiDrive& drive, const std::string& leg, double x_m, double z_m) {
    const double cosine = (x_m * x_m + z_m * z_m - thigh_m * thigh_m - shin_m * shin_m) / (2.0 * thigh_m * shin_m);
    const double knee_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double hip_rad =
        std::atan2(x_m, -z_m) + std::atan2(shin_m * std::sin(knee_rad), thigh_m + shin_m * std::cos(knee_rad));
    drive.joints.push_back({*protocol::Token::make(leg + "Leg1"), hip_rad});
    drive.joints.push_back({*protocol::Token::make(leg + "Leg2"), 0.1});
    drive.joints.push_back({*protocol::Token::make(leg + "Leg3"), knee_rad});
}

/// Bends the knees in five ticks: at once it would fall on its nose.
void stand(DrivenRobot& dog) {
    for (int tick = 1; tick <= 5; ++tick) {
        protocol::MultiDrive drive;
        for (const char* leg : {"LF", "RF", "LH", "RH"})
            put(drive, leg, forward_m * tick / 5.0, -upright_m + (upright_m - standing_m) * tick / 5.0);
        dog.drive->obey(drive);
        dog.run(Seconds{0.2});
    }
    dog.run(Seconds{2.0});
}

/// One tick of a trot: legs on a diagonal lift, step forward, and push back while the other two do so.
protocol::MultiDrive trot(int tick, double step_m) {
    constexpr double lift_m = 0.01;
    protocol::MultiDrive drive;
    const auto move = [&](const std::string& leg, int phase) {
        const double x_m[] = {forward_m, forward_m + step_m / 2.0, forward_m, forward_m - step_m / 2.0};
        const double z_m = phase % 4 == 0 ? -standing_m + lift_m : -standing_m;
        put(drive, leg, x_m[phase % 4], z_m);
    };
    move("LF", tick);
    move("RH", tick);
    move("RF", tick + 2);
    move("LH", tick + 2);
    return drive;
}

struct Trot {
    double tilt_rad = 0.0;   ///< the largest angle of the body's z axis from the vertical
    double farthest_m = 0.0; ///< the largest x; at a wall the dog may turn and walk away from it
};

Trot trotFor30s(DrivenRobot& dog) {
    Trot trotted;
    for (int tick = 0; tick < 150; ++tick) {
        dog.drive->obey(trot(tick, 0.05));
        dog.run(Seconds{0.2}, [&] {
            const Vec3 up = dog.pose().rotation() * Vec3::UnitZ();
            trotted.tilt_rad = std::max(trotted.tilt_rad, std::acos(std::clamp(up.z(), -1.0, 1.0)));
            trotted.farthest_m = std::max(trotted.farthest_m, dog.position_m().x());
        });
    }
    return trotted;
}

} // namespace

class tst_LegDrive : public QObject {
    Q_OBJECT

private slots:
    void standsForAMinute() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        stand(dog);
        const Vec3 from_m = dog.position_m();
        dog.run(Seconds{60.0});
        QVERIFY((dog.position_m() - from_m).norm() < 0.005);
        QVERIFY(dog.drive->idle());
        QVERIFY(std::abs(dog.pose().roll_rad) < 0.05);
        QVERIFY(std::abs(dog.pose().pitch_rad) < 0.1);
    }

    void walksOnItsPaws() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        stand(dog);
        const Vec3 from_m = dog.position_m();
        double worst_tilt_rad = 0.0;
        for (int tick = 0; tick < 50; ++tick) {
            dog.drive->obey(trot(tick, 0.05));
            QVERIFY(!dog.drive->idle());
            dog.run(Seconds{0.2}, [&] {
                const Pose pose = dog.pose();
                worst_tilt_rad = std::max({worst_tilt_rad, std::abs(pose.roll_rad), std::abs(pose.pitch_rad)});
            });
        }
        const Vec3 way_m = dog.position_m() - from_m;
        // Nothing steers it, so it may walk a curve.
        const double curve_m = way_m.head<2>().norm();
        QVERIFY2(curve_m > 10.0 * 0.05 && way_m.x() > 0.0, qPrintable(QString("%1 %2").arg(way_m.x()).arg(way_m.y())));
        QVERIFY2(worst_tilt_rad < 0.4, qPrintable(QString::number(worst_tilt_rad)));
    }

    void staysOnItsPawsAtObstacles_data() {
        QTest::addColumn<World>("world");
        QTest::addColumn<double>("largest_deg");
        QTest::addColumn<double>("gets_to_m");
        QTest::addColumn<double>("gets_no_further_m");
        const auto box = [](const Vec3& center_m, const Vec3& size_m) {
            World world = flatWorld();
            world.boxes.push_back({.center_in_map = {.position_m = center_m}, .size_m = size_m});
            return world;
        };
        const World ramp =
            groundOf([](const Vec2& at) { return std::max(0.0, at.x() - 0.5) * std::tan(radians(30.0)); });
        QTest::newRow("wall") << box({0.75, 0.0, 0.5}, {0.5, 4.0, 1.0}) << 15.0 << 0.2 << 0.5;
        QTest::newRow("step of 5 cm: too high") << box({2.5, 0.0, 0.025}, {4.0, 4.0, 0.05}) << 20.0 << 0.2 << 0.6;
        QTest::newRow("ramp of 30 degrees") << ramp << 25.0 << 0.2 << 1.5;
        QTest::newRow("drop of 20 cm: it falls on its nose")
            << box({-1.5, 0.0, 0.1}, {4.0, 4.0, 0.2}) << 180.0 << 0.3 << 1.5;
    }

    void staysOnItsPawsAtObstacles() {
        QFETCH(const World, world);
        QFETCH(const double, largest_deg);
        QFETCH(const double, gets_to_m);
        QFETCH(const double, gets_no_further_m);
        // Whether a paw slips is a matter of millimeters, so the middle of five starts counts.
        std::vector<double> tilts_deg;
        std::vector<double> farthest_m;
        for (int start = 0; start < 5; ++start) {
            DrivenRobot dog(world, robots, "ERS", 0.1, 0.13);
            const bool on_box = !world.boxes.empty() && world.boxes.front().center_in_map.position_m.x() < 0.0;
            dog.physics->place(dog.body.id(), Pose{dog.position_m() + Vec3(-0.001 * start, 0.0, on_box ? 0.2 : 0.0)});
            stand(dog);
            const auto [tilt_rad, way_m] = trotFor30s(dog);
            tilts_deg.push_back(degrees(tilt_rad));
            farthest_m.push_back(way_m);
            qInfo("largest tilt %.0f degrees, x %.2f m, height %.2f m", degrees(tilt_rad), way_m, dog.position_m().z());
            QVERIFY(dog.position_m().z() > 0.02 && dog.position_m().z() < 1.0);
        }
        std::ranges::sort(tilts_deg);
        std::ranges::sort(farthest_m);
        QVERIFY(tilts_deg[2] <= largest_deg);
        QVERIFY(farthest_m[2] > gets_to_m && farthest_m[2] < gets_no_further_m);
    }

    // Whether it pushes the other or passes it is a matter of chance.
    void doesNotWalkThroughAnotherOfItsKind() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        RobotBody other(*dog.physics, dog.model, Pose{{0.6, 0.13, 0.2}});
        stand(dog);
        const auto [tilt_rad, farthest_m] = trotFor30s(dog);
        const double apart_m = (dog.position_m() - dog.physics->state(other.id()).position_m).norm();
        qInfo("largest tilt %.0f degrees, x %.2f m, %.2f m apart", degrees(tilt_rad), farthest_m, apart_m);
        QVERIFY(degrees(tilt_rad) < 15.0 && farthest_m > 0.25 && apart_m > 0.12);
    }

    void servosGoWhereTheyAreToldWithinTheirLimits_data() {
        QTest::addColumn<double>("wanted_rad");
        QTest::addColumn<double>("reached_rad");
        QTest::newRow("within") << 0.5 << 0.5;
        QTest::newRow("beyond the upper one") << 4.0 << radians(88.0);
        QTest::newRow("beyond the lower one") << -4.0 << radians(-88.0);
    }
    void servosGoWhereTheyAreToldWithinTheirLimits() {
        QFETCH(double, wanted_rad);
        QFETCH(double, reached_rad);
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        QVERIFY(dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::Angle, wanted_rad}));
        dog.run(Seconds{2.0});
        QVERIFY(std::abs(dog.joint("HeadPan").position - reached_rad) < 0.02);
    }

    void everyOrderOfASingleJoint() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        stand(dog);
        dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::Speed, 0.5});
        dog.run(Seconds{1.0});
        QVERIFY(std::abs(dog.joint("HeadPan").velocity - 0.5) < 0.05);
        dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::Brake, 1.0});
        dog.run(Seconds{0.5});
        QVERIFY(std::abs(dog.joint("HeadPan").velocity) < 0.05);
        const double stopped_rad = dog.joint("HeadPan").position;
        dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::RelativeAngle, -0.3});
        dog.run(Seconds{1.0});
        QVERIFY(std::abs(dog.joint("HeadPan").position - stopped_rad + 0.3) < 0.02);
        dog.drive->obey(protocol::JointDrive{"headpan", protocol::JointOrder::Torque, 1.0});
        dog.run(Seconds{2.0});
        QVERIFY(std::abs(dog.joint("HeadPan").position - radians(88.0)) < 0.05); // at its stop
        QVERIFY(!dog.drive->obey(protocol::JointDrive{"NoSuchJoint", protocol::JointOrder::Angle, 0.0}));
        QVERIFY(!dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::Angle, std::nan("")}));
        QVERIFY(!dog.drive->obey(protocol::SkidDrive{1.0, 1.0}));
    }

    void setMovesAndSoftensJoints() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        stand(dog);
        const double height_m = dog.position_m().z();
        QVERIFY(dog.drive->obey(protocol::SetJoint{"HeadPan", protocol::JointOpcode::Angle, -0.4}));
        dog.run(Seconds{1.0});
        QVERIFY(std::abs(dog.joint("HeadPan").position + 0.4) < 0.02);
        QVERIFY(dog.drive->obey(protocol::SetJoint{"AllJoints", protocol::JointOpcode::Stiffness, 0.0}));
        dog.run(Seconds{2.0});
        QVERIFY(dog.position_m().z() < 0.8 * height_m);
    }

    void anEmptyBatteryLetsItSinkDown() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        stand(dog);
        const double height_m = dog.position_m().z();
        dog.drive->switchOff();
        dog.run(Seconds{2.0});
        QVERIFY(dog.position_m().z() < 0.8 * height_m);
        QVERIFY(!dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::Angle, 0.3}));
    }

    void tellsEveryJointsAngle() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        dog.drive->obey(protocol::JointDrive{"HeadPan", protocol::JointOrder::Angle, 0.3});
        dog.run(Seconds{2.0});
        protocol::RobotState state;
        dog.drive->addState(state);
        QCOMPARE(state.joints.size(), std::size_t{15});
        QCOMPARE(state.joints.front().name, std::string("LFLeg1"));
        QCOMPARE(state.joints[13].name, std::string("HeadPan"));
        QVERIFY(std::abs(state.joints[13].angle_rad - 0.3) < 0.02);
    }

    void hasTheLegJointsThatBehaviorsName() {
        DrivenRobot dog(flatWorld(), robots, "ERS", 0.1, 0.13);
        protocol::RobotState state;
        dog.drive->addState(state);
        std::size_t joint = 0;
        for (const auto& leg : agent::ers_leg_joints)
            for (const std::string_view name : leg)
                QCOMPARE(state.joints.at(joint++).name, std::string(name));
    }
};

USAR_TEST(tst_LegDrive)

} // namespace tst_leg_drive

#include "tst_leg_drive.moc"
