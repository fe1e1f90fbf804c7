#include <cmath>

#include <QObject>
#include <QTest>

#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_air_robot_contacts {

using namespace usar;
using namespace usar::sim;

namespace {

World treeWorld() {
    World world = flatWorld();
    world.plants.push_back({{5.0, 0.0, 0.0}, 0.3, 5.0, CrownShape::Sphere, 1.5, 0.0});
    world.plants.push_back({{0.0, 8.0, 0.0}, 0.2, 3.0, CrownShape::Cone, 1.5, 4.0});
    world.boxes.push_back({Pose{{0.0, -8.0, 1.5}, 0.0, 0.0, 0.0}, {4.0, 4.0, 3.0}});
    return world;
}

} // namespace

class tst_AirRobotContacts : public QObject {
    Q_OBJECT

private slots:
    void landsRestsAndTakesOffAgain_data() {
        QTest::addColumn<double>("slope_deg");
        // On 30 degrees it slides, and tips over as chance will have it.
        for (const int slope_deg : {0, 5, 10, 15, 20, 25})
            QTest::addRow("slope of %d degrees", slope_deg) << static_cast<double>(slope_deg);
    }
    void landsRestsAndTakesOffAgain() {
        QFETCH(double, slope_deg);
        Flight flight(slopeWorld(radians(slope_deg)), onTheGround({0.0, 0.0, 0.0}));
        flight.run(Seconds{6.0});
        QVERIFY(flight.atRest());
        flight.drive(0.0, 0.0, 1.0);
        flight.run(Seconds{5.0});
        QCOMPARE(flight.robot.motors(), MotorState::Flying);
        QVERIFY(flight.pose().position_m.z() > 3.0);
        flight.drive(0.0, 0.0, -0.4);
        flight.run(Seconds{30.0});
        QVERIFY(flight.atRest());
        QCOMPARE(flight.robot.motors(), MotorState::Idle);
        QCOMPARE(flight.robot.collisions(), 0);
        QVERIFY(std::abs(degrees(flight.pose().pitch_rad) + slope_deg) < 1.0);
    }

    /// One leg finds the ground while the others are in the air (survey 152552).
    void standsWhereItIsPutOnASlope_data() {
        QTest::addColumn<double>("slope_deg");
        QTest::addColumn<double>("above_m"); // from the highest ground under its legs to these
        for (const double slope_deg : {5.0, 9.0, 12.0, 14.0})
            for (const double above_m : {0.0, 0.02, 0.1})
                QTest::addRow("%.0f degrees, %.2f m", slope_deg, above_m) << slope_deg << above_m;
    }
    void standsWhereItIsPutOnASlope() {
        QFETCH(double, slope_deg);
        QFETCH(double, above_m);
        for (int yaw_deg = 0; yaw_deg < 360; yaw_deg += 15) {
            FlightStart spawn = onTheGround({0.0, 0.0, 0.0});
            spawn.base_in_map.position_m.z() = 0.21 + 0.36 * std::tan(radians(slope_deg)) + above_m;
            spawn.base_in_map.yaw_rad = radians(yaw_deg);
            Flight flight(slopeWorld(radians(slope_deg)), spawn);
            flight.run(Seconds{6.0});
            QVERIFY2(flight.atRest() && flight.robot.collisions() == 0,
                     qPrintable(QString("yaw %1 degrees").arg(yaw_deg)));
        }
    }

    void landsOnRoughGroundInAnyDirection_data() {
        QTest::addColumn<double>("yaw_deg");
        for (const int yaw_deg : {0, 40, 110, 200, 300})
            QTest::addRow("yaw %d", yaw_deg) << static_cast<double>(yaw_deg);
    }
    void landsOnRoughGroundInAnyDirection() {
        QFETCH(double, yaw_deg);
        const World world =
            groundOf([](const Vec2& p) { return 0.3 * std::sin(1.3 * p.x()) * std::cos(0.9 * p.y()) + 0.2 * p.y(); });
        FlightStart spawn = inTheAir({2.0, 1.0, 3.0});
        spawn.base_in_map.yaw_rad = radians(yaw_deg);
        Flight flight(world, spawn);
        flight.drive(0.0, 0.0, -0.5);
        flight.run(Seconds{15.0});
        QVERIFY(flight.atRest());
        QCOMPARE(flight.robot.collisions(), 0);
        const Vec3 before_m = flight.pose().position_m;
        flight.run(Seconds{60.0});
        QVERIFY((flight.pose().position_m - before_m).norm() < 0.03);
        QVERIFY(flight.atRest());
    }

    void touchdownSpeedDecides_data() {
        QTest::addColumn<double>("sink_m_s");
        QTest::addColumn<bool>("breaks");
        QTest::newRow("gently") << 0.3 << false;
        QTest::newRow("firmly") << 0.8 << false;
        QTest::newRow("hard") << 1.3 << true;
        QTest::newRow("as fast as it can") << 2.0 << true;
    }
    void touchdownSpeedDecides() {
        QFETCH(double, sink_m_s);
        QFETCH(bool, breaks);
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 5.0}));
        flight.drive(0.0, 0.0, -sink_m_s);
        flight.run(Seconds{20.0});
        QCOMPARE(flight.robot.broken(), breaks);
        QCOMPARE(flight.robot.collisions(), breaks ? 1 : 0);
    }

    void aHitBreaksTheRotorsAndItFalls_data() {
        QTest::addColumn<Vec3>("from_m");
        QTest::addColumn<Vec3>("velocity_m_s");
        QTest::newRow("trunk") << Vec3(0.0, 0.0, 2.0) << Vec3(1.5, 0.0, 0.0);
        QTest::newRow("round crown from the side") << Vec3(0.0, 0.0, 5.2) << Vec3(1.5, 0.0, 0.0);
        QTest::newRow("wall") << Vec3(0.0, -2.0, 2.0) << Vec3(0.0, -1.5, 0.0);
        QTest::newRow("top of a fir with the belly") << Vec3(0.0, 8.0, 9.0) << Vec3(0.0, 0.0, -1.0);
        QTest::newRow("sideways into the fir, backward") << Vec3(4.0, 8.0, 4.0) << Vec3(-1.5, 0.0, 0.0);
        QTest::newRow("crown from below") << Vec3(5.9, 0.0, 2.0) << Vec3(0.0, 0.0, 1.0);
    }
    void aHitBreaksTheRotorsAndItFalls() {
        QFETCH(Vec3, from_m);
        QFETCH(Vec3, velocity_m_s);
        Flight flight(treeWorld(), inTheAir(from_m));
        flight.drive(velocity_m_s.x(), velocity_m_s.y(), velocity_m_s.z());
        flight.run(Seconds{10.0});
        QVERIFY(flight.robot.broken());
        QVERIFY(flight.robot.collisions() >= 1);
        flight.drive(0.0, 0.0, 2.0);
        flight.run(Seconds{10.0});
        QVERIFY(flight.velocity_m_s().norm() < 0.5);
        QVERIFY(flight.pose().position_m.z() < from_m.z());
        QVERIFY(flight.pose().position_m.z() > -0.1);
    }

    void theGuardForgivesASlowTouch() {
        Flight flight(treeWorld(), inTheAir({3.5, 0.0, 2.0}));
        flight.drive(0.25, 0.0, 0.0);
        flight.run(Seconds{4.0});
        QVERIFY(!flight.robot.broken());
        QVERIFY(flight.robot.collisions() >= 1);
        flight.drive(-0.5, 0.0, 0.0);
        flight.run(Seconds{4.0});
        QVERIFY(!flight.robot.broken());
        QVERIFY(flight.pose().position_m.x() < 3.5);
    }

    void theGuardBearsWhatLiesOnIt_data() {
        QTest::addColumn<Pose>("thing_in_map");
        QTest::addColumn<Vec3>("size_m");
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<bool>("breaks");
        const Pose above{{0.0, 0.0, 4.0}, 0.0, 0.0, 0.0};
        const Pose over_rotor{{0.19, 0.19, 4.0}, 0.0, 0.0, 0.0};
        QTest::newRow("a roof, slowly") << above << Vec3(6.0, 6.0, 1.0) << 0.3 << false;
        QTest::newRow("a roof, with care") << above << Vec3(6.0, 6.0, 1.0) << 0.42 << false;
        QTest::newRow("a roof, fast") << above << Vec3(6.0, 6.0, 1.0) << 1.0 << true;
        QTest::newRow("the border of a roof over two rotors")
            << Pose{{3.1, 0.0, 4.0}, 0.0, 0.0, 0.0} << Vec3(6.0, 6.0, 1.0) << 0.3 << false;
        QTest::newRow("a beam across the ring") << over_rotor << Vec3(0.1, 6.0, 1.0) << 0.3 << false;
        QTest::newRow("a post that hangs into a rotor") << over_rotor << Vec3(0.1, 0.1, 1.0) << 0.1 << true;
    }
    void theGuardBearsWhatLiesOnIt() {
        QFETCH(Pose, thing_in_map);
        QFETCH(Vec3, size_m);
        QFETCH(double, climb_m_s);
        QFETCH(bool, breaks);
        World world = flatWorld();
        world.boxes.push_back({thing_in_map, size_m});
        Flight flight(world, inTheAir({0.0, 0.0, 2.0}));
        flight.drive(0.0, 0.0, climb_m_s, 0.6);
        flight.run(Seconds{16.0});
        QCOMPARE(flight.robot.broken(), breaks);
        QVERIFY(flight.robot.collisions() >= 1);
        if (breaks)
            return;
        flight.drive(0.0, 0.0, -0.3);
        flight.run(Seconds{4.0});
        QVERIFY(!flight.robot.broken());
        QVERIFY(flight.pose().position_m.z() < 3.3);
    }

    void aTwigReachesThroughTheGuardAtAnySpeed() {
        Flight flight(treeWorld(), inTheAir({0.12, 8.3, 7.5})); // The tip of the fir is below a rotor.
        flight.drive(0.0, 0.0, -0.1);
        flight.run(Seconds{10.0});
        QVERIFY(flight.robot.broken());
    }

    void landsOnARoof() {
        Flight flight(treeWorld(), inTheAir({0.0, -8.0, 5.0}));
        flight.drive(0.0, 0.0, -0.5);
        flight.run(Seconds{12.0});
        QVERIFY(flight.atRest());
        QCOMPARE(flight.robot.collisions(), 0);
        QVERIFY(std::abs(flight.pose().position_m.z() - 3.21) < 0.01);
    }

    void namesThePartThatWasTouched_data() {
        QTest::addColumn<Vec3>("point_m");
        QTest::addColumn<int>("part");
        QTest::newRow("foot") << Vec3(0.25, -0.25, -0.21) << static_cast<int>(AirRobotPart::Gear);
        QTest::newRow("side of a leg") << Vec3(0.27, 0.25, -0.12) << static_cast<int>(AirRobotPart::Gear);
        QTest::newRow("belly") << Vec3(0.05, 0.0, -0.10) << static_cast<int>(AirRobotPart::Belly);
        QTest::newRow("rim") << Vec3(0.4995, 0.0, 0.0) << static_cast<int>(AirRobotPart::Guard);
        QTest::newRow("hub from above") << Vec3(0.0, 0.0, 0.025) << static_cast<int>(AirRobotPart::Guard);
        QTest::newRow("rotor from above") << Vec3(0.25, 0.15, 0.025) << static_cast<int>(AirRobotPart::RotorDisc);
        QTest::newRow("rotor from below") << Vec3(-0.2, 0.2, -0.025) << static_cast<int>(AirRobotPart::RotorDisc);
    }
    void namesThePartThatWasTouched() {
        QFETCH(Vec3, point_m);
        QFETCH(int, part);
        QCOMPARE(static_cast<int>(partAt(AirRobotParameters{}, point_m)), part);
    }

    void twoThatMeetBothFall() {
        World world = flatWorld();
        const auto physics = makePhysics(world);
        RotorDrive left(*physics, physics->add(airRobotBody(), {.position_m = {-2.0, 0.1, 5.0}}), false);
        RotorDrive right(*physics, physics->add(airRobotBody(), {.position_m = {2.0, 0.0, 5.0}}), false);
        left.obey(protocol::Command(protocol::AerialDrive{.forward_m_s = 1.5}));
        right.obey(protocol::Command(protocol::AerialDrive{.forward_m_s = -1.5}));
        for (int i = 0; i < 1500; ++i) {
            for (RotorDrive* robot : {&left, &right})
                robot->beforeStep(physics_dt);
            physics->step(physics_dt);
            for (RotorDrive* robot : {&left, &right})
                robot->afterStep(physics_dt);
        }
        QVERIFY(left.broken() && right.broken());
        QVERIFY(left.state().position_m.z() < 1.0 && right.state().position_m.z() < 1.0);
    }
};

USAR_TEST(tst_AirRobotContacts)

} // namespace tst_air_robot_contacts

#include "tst_air_robot_contacts.moc"
