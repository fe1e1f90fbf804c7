// What ground robots do at a wall, a step, a ramp, a drop and another robot: they stall, slip or climb, and none turns
// over at what its kind can meet.
#include <cmath>

#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/driven_robot.h"
#include "tests/suite/suite.h"

namespace tst_obstacles {

using namespace usar;
using namespace usar::sim;

namespace {

const std::string robots = USAR_SOURCE_DIR "/resources/robots";

World with(const Box& box) {
    World world = flatWorld();
    world.boxes.push_back(box);
    return world;
}

/// Every obstacle begins at x = 4 m.
Box boxFrom4m(const Vec3& size_m) {
    return {.center_in_map = {.position_m = {4.0 + size_m.x() / 2.0, 0.0, size_m.z() / 2.0}}, .size_m = size_m};
}

World wall() {
    return with(boxFrom4m({0.5, 20.0, 2.0}));
}
World step() {
    return with(boxFrom4m({20.0, 20.0, 0.05}));
}
World ramp() {
    return groundOf([](const Vec2& at) { return std::clamp(at.x() - 4.0, 0.0, 8.0) * std::tan(radians(30.0)); });
}
/// A table of 20 cm that ends at x = 4 m.
World drop() {
    return with({.center_in_map = {.position_m = {-6.0, 0.0, 0.1}}, .size_m = {20.0, 20.0, 0.2}});
}

bool isCar(const DrivenRobot& robot) {
    return robot.model.drive.kind == "ackermann";
}

void drive(DrivenRobot& robot, double speed_m_s) {
    const double spin_rad_s = speed_m_s / robot.model.drive.numbers.at("wheel_radius");
    if (isCar(robot))
        robot.drive->obey(protocol::AckermannDrive{spin_rad_s, 0.0, 0.0});
    else
        robot.drive->obey(protocol::SkidDrive{spin_rad_s, spin_rad_s});
}

/// How a robot fares.
struct Trip {
    double largest_tilt_rad = 0.0; ///< of the base's z axis from the vertical
    double end_tilt_rad = 0.0;
    double end_x_m = 0.0;
};

double tiltOf(const Pose& base_in_map) {
    return std::acos(std::clamp((base_in_map.rotation() * Vec3::UnitZ()).z(), -1.0, 1.0));
}

Trip travel(
    DrivenRobot& robot, double speed_m_s, Seconds duration, const std::function<void()>& each = [] {}) {
    Trip trip;
    drive(robot, speed_m_s);
    robot.run(duration, [&] {
        trip.largest_tilt_rad = std::max(trip.largest_tilt_rad, tiltOf(robot.pose()));
        each();
    });
    trip.end_tilt_rad = tiltOf(robot.pose());
    trip.end_x_m = robot.position_m().x();
    qInfo("largest tilt %.1f degrees, in the end %.1f, x %.2f m", degrees(trip.largest_tilt_rad),
          degrees(trip.end_tilt_rad), trip.end_x_m);
    return trip;
}

} // namespace

class tst_Obstacles : public QObject {
    Q_OBJECT

private slots:
    void pushesAWallWithoutTurningOver_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<bool>("backward");
        QTest::addColumn<double>("skew_deg");
        for (const char* const name : {"P2DX", "P2AT", "Sedan"})
            for (const double speed_m_s : {0.13, 0.26, 0.65})
                for (const bool backward : {false, true})
                    for (const double skew_deg : {0.0, 20.0})
                        QTest::addRow("%s, %.2f m/s%s, %.0f degrees off", name, speed_m_s, backward ? ", backward" : "",
                                      skew_deg)
                            << name << speed_m_s << backward << skew_deg;
    }
    void pushesAWallWithoutTurningOver() {
        QFETCH(const QString, name);
        QFETCH(const double, speed_m_s);
        QFETCH(const bool, backward);
        QFETCH(const double, skew_deg);
        const double start_x_m = name == "Sedan" ? 1.5 : 3.5;
        DrivenRobot robot(wall(), robots, name.toStdString(), start_x_m, 0.13,
                          radians(skew_deg) + (backward ? pi : 0.0));
        robot.run(Seconds{1.0});
        const Trip trip = travel(robot, backward ? -speed_m_s : speed_m_s, Seconds{20.0});
        QVERIFY(trip.largest_tilt_rad < radians(8.0));
        QVERIFY(trip.end_x_m < 4.0);
        QVERIFY(robot.drive->collisions() > 0);
    }

    void meetsOtherThings_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<World>("world");
        QTest::addColumn<double>("largest_deg");
        QTest::addColumn<double>("end_deg");
        QTest::addColumn<double>("gets_to_m");
        QTest::newRow("P2DX, step: its caster stays below") << "P2DX" << step() << 25.0 << 25.0 << 3.9;
        QTest::newRow("P2AT, step") << "P2AT" << step() << 25.0 << 3.0 << 6.0;
        QTest::newRow("Sedan, step") << "Sedan" << step() << 10.0 << 3.0 << 6.0;
        QTest::newRow("P2DX, ramp: its nose meets it first") << "P2DX" << ramp() << 5.0 << 5.0 << 3.7;
        QTest::newRow("P2AT, ramp") << "P2AT" << ramp() << 40.0 << 35.0 << 5.0;
        QTest::newRow("Sedan, ramp: its nose meets it first") << "Sedan" << ramp() << 5.0 << 5.0 << 2.0;
        QTest::newRow("P2DX, drop") << "P2DX" << drop() << 80.0 << 80.0 << 3.9;
        QTest::newRow("P2AT, drop") << "P2AT" << drop() << 60.0 << 60.0 << 3.9;
        QTest::newRow("Sedan, drop: it hangs on its belly") << "Sedan" << drop() << 15.0 << 5.0 << 2.7;
    }
    void meetsOtherThings() {
        QFETCH(const QString, name);
        QFETCH(const World, world);
        QFETCH(const double, largest_deg);
        QFETCH(const double, end_deg);
        QFETCH(const double, gets_to_m);
        const bool car = name == "Sedan";
        DrivenRobot robot(world, robots, name.toStdString(), car ? 1.0 : 3.0, 0.13);
        if (!world.boxes.empty() && world.boxes.front().center_in_map.position_m.x() < 0.0)
            robot.physics->place(robot.body.id(), Pose{robot.position_m() + Vec3(0.0, 0.0, 0.2)});
        robot.run(Seconds{1.0});
        const Trip trip = travel(robot, 0.5, Seconds{20.0});
        QVERIFY(degrees(trip.largest_tilt_rad) < largest_deg);
        QVERIFY(degrees(trip.end_tilt_rad) < end_deg);
        QVERIFY(trip.end_x_m > gets_to_m);
    }

    void pushesAnotherRobot_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("other");
        for (const char* const name : {"P2DX", "P2AT", "Sedan"})
            for (const char* const other : {"P2DX", "P2AT", "Sedan"})
                QTest::addRow("%s pushes %s", name, other) << name << other;
    }
    void pushesAnotherRobot() {
        QFETCH(const QString, name);
        QFETCH(const QString, other);
        DrivenRobot robot(flatWorld(), robots, name.toStdString(), name == "Sedan" ? -1.0 : 1.0, 0.13);
        const RobotModel model = DrivenRobot(flatWorld(), robots, other.toStdString(), 0.0, 0.0).model;
        RobotBody pushed(*robot.physics, model, Pose{{4.0, 0.0, other == "Sedan" ? 0.46 : 0.16}});
        const auto brakes = makeDrive(model, *robot.physics, pushed.id(), robot.world, false);
        QVERIFY(brakes.has_value());
        const auto standing = [&] { (*brakes)->beforeStep(physics_dt); };
        robot.run(Seconds{1.0}, standing);
        const Trip trip = travel(robot, 0.4, Seconds{20.0}, standing);
        pushed.afterStep();
        const double other_tilt_deg = degrees(tiltOf(pushed.base_in_map()));
        qInfo("the other: %.1f degrees, x %.2f m", other_tilt_deg, pushed.base_in_map().position_m.x());
        QVERIFY(degrees(trip.largest_tilt_rad) < 15.0);
        QVERIFY(other_tilt_deg < 60.0); // with its brakes on, a P2DX is pushed onto its nose
        QVERIFY(robot.drive->collisions() > 0);
    }
};

USAR_TEST(tst_Obstacles)

} // namespace tst_obstacles

#include "tst_obstacles.moc"
