// Robots on tracks and the other robots of old clients: at a wall, and what their flippers do.
#include <cmath>

#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/driven_robot.h"
#include "tests/sim/talker.h"
#include "tests/suite/suite.h"

namespace tst_tracked_robots {

using namespace usar;
using namespace usar::sim;

namespace {

const std::string robots = USAR_SOURCE_DIR "/resources/robots";
const std::vector<std::string> flippers{"FRFlipper", "FLFlipper", "RRFlipper", "RLFlipper"};

World withBox(const Vec3& center_m, const Vec3& size_m) {
    World world = flatWorld();
    world.boxes.push_back({.center_in_map = {.position_m = center_m}, .size_m = size_m});
    return world;
}

double tiltOf(const Pose& base_in_map) {
    return std::acos(std::clamp((base_in_map.rotation() * Vec3::UnitZ()).z(), -1.0, 1.0));
}

void roll(DrivenRobot& robot, double speed_m_s) {
    const double spin_rad_s = speed_m_s / robot.model.drive.numbers.at("wheel_radius");
    if (robot.model.drive.kind == "omni")
        robot.drive->obey(
            protocol::OmniDrive{{{0, spin_rad_s, {}}, {1, spin_rad_s, {}}, {2, spin_rad_s, {}}, {3, spin_rad_s, {}}}});
    else
        robot.drive->obey(protocol::SkidDrive{spin_rad_s, spin_rad_s});
}

/// Front and rear flippers to these angles above level.
void setFlippers(DrivenRobot& robot, double front_rad, double rear_rad) {
    robot.drive->obey(protocol::MultiDrive{
        {{"FRFlipper", front_rad}, {"FLflipper", front_rad}, {"RRFlipper", -rear_rad}, {"RLflipper", -rear_rad}}});
}

} // namespace

class tst_TrackedRobots : public QObject {
    Q_OBJECT

private slots:
    void pushesAWallWithoutTurningOver_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<bool>("backward");
        QTest::addColumn<double>("skew_deg");
        QTest::addColumn<double>("flippers_rad");
        const auto add = [](const char* name, double flippers_rad) {
            for (const double speed_m_s : {0.13, 0.5})
                for (const bool backward : {false, true})
                    for (const double skew_deg : {0.0, 20.0})
                        QTest::addRow("%s, flippers %.1f, %.2f m/s%s, %.0f degrees off", name, flippers_rad, speed_m_s,
                                      backward ? ", backward" : "", skew_deg)
                            << name << std::min(speed_m_s, std::string(name) == "P3AT" ? 0.12 : 1.0) << backward
                            << skew_deg << flippers_rad;
        };
        for (const char* const name : {"P3AT", "StereoP2AT", "ATRVJr", "OmniP2AT", "Talon", "Kenaf", "TeleMax"})
            add(name, 0.0);
        for (const char* const name : {"Talon", "Kenaf", "TeleMax"})
            add(name, 1.5);
    }
    void pushesAWallWithoutTurningOver() {
        QFETCH(const QString, name);
        QFETCH(const double, speed_m_s);
        QFETCH(const bool, backward);
        QFETCH(const double, skew_deg);
        QFETCH(const double, flippers_rad);
        DrivenRobot robot(withBox({4.25, 0.0, 1.0}, {0.5, 20.0, 2.0}), robots, name.toStdString(), 2.8, 0.13,
                          radians(skew_deg) + (backward ? pi : 0.0));
        setFlippers(robot, flippers_rad, flippers_rad);
        robot.run(Seconds{3.0});
        roll(robot, backward ? -speed_m_s : speed_m_s);
        double largest_rad = 0.0;
        robot.run(Seconds{20.0}, [&] { largest_rad = std::max(largest_rad, tiltOf(robot.pose())); });
        qInfo("largest tilt %.1f degrees, x %.2f m", degrees(largest_rad), robot.position_m().x());
        // The Talon's flippers, held up, slide up the wall a bit when they meet it at full speed.
        QVERIFY(largest_rad < radians(name == "Talon" ? 30.0 : 10.0));
        QVERIFY(robot.position_m().x() < 4.0);
        QVERIFY(robot.drive->collisions() > 0);
    }

    void flippersObeyMultidriveAndAreReported_data() {
        QTest::addColumn<double>("limit_rad");
        QTest::newRow("Talon") << 3.1;
        QTest::newRow("Kenaf") << 2.086;
        QTest::newRow("TeleMax") << 3.1;
    }
    void flippersObeyMultidriveAndAreReported() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say("INIT {ClassName USARBot." + std::string(QTest::currentDataTag()) +
                   "} {Name R1} {Location 0,0,-0.3}");
        steps(*simulation, 5);
        talker.say("MULTIDRIVE {FRFlipper 0.5}{FLflipper 0.75}{RRFlipper -0.5}{RLflipper -1}");
        steps(*simulation, 15);
        const std::vector<double> wanted_rad{0.5, 0.75, -0.5, -1.0};
        const auto state = talker.hearLast<protocol::RobotState>();
        QVERIFY(state.has_value());
        QCOMPARE(state->joints.size(), flippers.size());
        for (std::size_t i = 0; i < flippers.size(); ++i) {
            const auto joint = std::ranges::find(state->joints, flippers[i], &protocol::JointAngle::name);
            QVERIFY(joint != state->joints.end());
            QVERIFY2(std::abs(joint->angle_rad - wanted_rad[i]) < 0.02, qPrintable(QString::number(joint->angle_rad)));
        }
    }

    /// Pressed down, the four flippers lift the robot off its tracks.
    void flippersLiftTheRobot_data() {
        QTest::addColumn<double>("by_m");
        QTest::newRow("Talon") << 0.06;
        QTest::newRow("Kenaf") << 0.04;
        QTest::newRow("TeleMax") << 0.06;
    }
    void flippersLiftTheRobot() {
        QFETCH(const double, by_m);
        DrivenRobot robot(flatWorld(), robots, QTest::currentDataTag(), 0.0, 0.0);
        robot.run(Seconds{1.0});
        const double height_m = robot.position_m().z();
        setFlippers(robot, -1.2, -1.2);
        robot.run(Seconds{4.0});
        qInfo("lifted by %.3f m, tilt %.1f degrees", robot.position_m().z() - height_m, degrees(tiltOf(robot.pose())));
        QVERIFY(robot.position_m().z() > height_m + by_m);
        QVERIFY(tiltOf(robot.pose()) < radians(5.0));
    }

    /// The step stops the robot with its nose up, until its rear flippers press down and lift the tail.
    void flippersHelpOverAStep_data() {
        QTest::addColumn<double>("height_m");
        QTest::newRow("Talon") << 0.12;
        QTest::newRow("Kenaf") << 0.08;
        QTest::newRow("TeleMax") << 0.12;
    }
    void flippersHelpOverAStep() {
        QFETCH(const double, height_m);
        DrivenRobot robot(withBox({9.0, 0.0, height_m / 2.0}, {10.0, 20.0, height_m}), robots, QTest::currentDataTag(),
                          2.8, 0.0);
        setFlippers(robot, 0.7, 0.0);
        robot.run(Seconds{2.0});
        roll(robot, 0.25);
        robot.run(Seconds{15.0});
        const double stuck_at_m = robot.position_m().x();
        setFlippers(robot, 0.2, -0.6);
        robot.run(Seconds{10.0});
        qInfo("stuck at x %.2f m, then gets to %.2f m, tilt %.1f degrees", stuck_at_m, robot.position_m().x(),
              degrees(tiltOf(robot.pose())));
        QVERIFY(stuck_at_m < 4.1);
        QVERIFY(robot.position_m().x() > 4.5);
        QVERIFY(tiltOf(robot.pose()) < radians(10.0));
    }
};

USAR_TEST(tst_TrackedRobots)

} // namespace tst_tracked_robots

#include "tst_tracked_robots.moc"
