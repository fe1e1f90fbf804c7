#include <QObject>
#include <QTest>

#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_air_robot_flight {

using namespace usar;
using namespace usar::sim;

class tst_AirRobotFlight : public QObject {
    Q_OBJECT

private slots:
    void hoversWithoutDrifting() {
        Flight flight(flatWorld(), inTheAir({1.0, 2.0, 10.0}));
        flight.run(Seconds{60.0});
        QVERIFY((flight.pose().position_m - Vec3(1.0, 2.0, 10.0)).norm() < 0.01);
        QCOMPARE(flight.robot.motors(), MotorState::Flying);
    }

    void hoverThrustIsItsWeight() {
        const AirRobotParameters parameters;
        Rotors rotors(parameters);
        rotors.command({parameters.mass_kg * gravity_m_s2, Vec3(0.1, -0.2, 0.05)});
        for (int i = 0; i < 500; ++i)
            rotors.step(physics_dt);
        QVERIFY(std::abs(rotors.wrench().thrust_n - 9.81) < 1e-6);
        QVERIFY((rotors.wrench().torque_n_m - Vec3(0.1, -0.2, 0.05)).norm() < 1e-6);
    }

    void rotorsLagAndHaveALimit() {
        const AirRobotParameters parameters;
        Rotors rotors(parameters);
        rotors.command({100.0, Vec3::Zero()});
        for (Seconds t{0.0}; t < parameters.rotor_lag; t += Seconds{0.001})
            rotors.step(Seconds{0.001});
        QVERIFY(std::abs(rotors.wrench().thrust_n / 24.0 - (1.0 - std::exp(-1.0))) < 0.01);
        for (int i = 0; i < 1000; ++i)
            rotors.step(Seconds{0.001});
        QVERIFY(std::abs(rotors.wrench().thrust_n - 24.0) < 1e-6);
    }

    void aStepOfOneMetrePerSecondSettlesInTwoSeconds_data() {
        QTest::addColumn<Vec3>("direction");
        QTest::newRow("forward") << Vec3(1.0, 0.0, 0.0);
        QTest::newRow("backward") << Vec3(-1.0, 0.0, 0.0);
        QTest::newRow("left") << Vec3(0.0, 1.0, 0.0);
        QTest::newRow("right") << Vec3(0.0, -1.0, 0.0);
        QTest::newRow("up") << Vec3(0.0, 0.0, 1.0);
        QTest::newRow("down") << Vec3(0.0, 0.0, -1.0);
    }
    void aStepOfOneMetrePerSecondSettlesInTwoSeconds() {
        QFETCH(Vec3, direction);
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 15.0}));
        flight.drive(direction.x(), direction.y(), direction.z());
        double fastest_m_s = 0.0;
        flight.run(Seconds{6.0}, [&](Seconds t) {
            const double along_m_s = flight.velocity_m_s().dot(direction);
            fastest_m_s = std::max(fastest_m_s, along_m_s);
            if (t > Seconds{2.0})
                QVERIFY(std::abs(along_m_s - 1.0) < 0.05);
        });
        QVERIFY(fastest_m_s < 1.05);
        QVERIFY((flight.velocity_m_s() - direction).norm() < 0.02);
    }

    void holdsItsHeightWhileItFliesAndTurns() {
        Flight flight(flatWorld(), inTheAir({-20.0, 0.0, 6.0}));
        const auto check = [&](Seconds) { QVERIFY(std::abs(flight.pose().position_m.z() - 6.0) < 0.1); };
        flight.drive(2.0, 0.0, 0.0);
        flight.run(Seconds{5.0}, check);
        flight.drive(2.0, 0.0, 0.0, 0.6);
        flight.run(Seconds{10.0}, check);
        flight.drive(-2.0, 1.0, 0.0, -0.6);
        flight.run(Seconds{5.0}, check);
    }

    void staysWithinTheMakersLimits() {
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 10.0}));
        double most_tilt_rad = 0.0;
        double most_tilt_rate_rad_s = 0.0;
        double last_pitch_rad = 0.0;
        const auto watch = [&](Seconds) {
            const double tilt_rad = std::acos((flight.robot.state().rotation * Vec3::UnitZ()).z());
            most_tilt_rad = std::max(most_tilt_rad, tilt_rad);
            const double pitch_rad = flight.pose().pitch_rad;
            most_tilt_rate_rad_s =
                std::max(most_tilt_rate_rad_s, std::abs(pitch_rad - last_pitch_rad) / physics_dt.count());
            last_pitch_rad = pitch_rad;
        };
        for (const double speed_m_s : {2.0, -2.0, 2.0, -2.0}) {
            flight.drive(speed_m_s, 0.0, 0.0);
            flight.run(Seconds{2.5}, watch);
        }
        QVERIFY(most_tilt_rad < radians(25.5));
        QVERIFY(most_tilt_rad > radians(8.0));
        QVERIFY(most_tilt_rate_rad_s < 0.67 * 1.15);
        flight.drive(0.0, 0.0, 0.0, 9.0);
        flight.run(Seconds{3.0});
        QVERIFY(std::abs(flight.robot.state().rate_rad_s.z() - 1.745) < 0.02);
    }

    void keepsTheTermsThatADriveLeavesOut() {
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 10.0}));
        flight.drive(0.5, -0.25, 0.125, 0.75);
        flight.robot.obey(protocol::Command(protocol::AerialDrive{.forward_m_s = 1.0}));
        QCOMPARE(flight.robot.command(), (VelocityCommand{1.0, -0.25, 0.125, 0.75}));
    }

    void takesDriveTermsInItsLimits_data() {
        QTest::addColumn<double>("given");
        QTest::addColumn<bool>("normalized");
        QTest::addColumn<double>("forward_m_s");
        QTest::addColumn<double>("yaw_rate_rad_s");
        QTest::newRow("metres per second") << 1.5 << false << 1.5 << 1.5;
        QTest::newRow("too fast") << 7.0 << false << 2.0 << 1.745;
        QTest::newRow("too fast backward") << -7.0 << false << -2.0 << -1.745;
        QTest::newRow("per cent") << 40.0 << true << 0.8 << 0.698;
        QTest::newRow("more than all") << 250.0 << true << 2.0 << 1.745;
        QTest::newRow("not a number") << std::nan("") << false << 0.0 << 0.0;
    }
    void takesDriveTermsInItsLimits() {
        QFETCH(double, given);
        QFETCH(bool, normalized);
        QFETCH(double, forward_m_s);
        QFETCH(double, yaw_rate_rad_s);
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 10.0}));
        flight.robot.obey(protocol::Command(protocol::AerialDrive{given, given, given, given, normalized}));
        QVERIFY(std::abs(flight.robot.command().forward_m_s - forward_m_s) < 1e-12);
        QVERIFY(std::abs(flight.robot.command().left_m_s - forward_m_s) < 1e-12);
        QVERIFY(std::abs(flight.robot.command().climb_m_s - forward_m_s) < 1e-12);
        QVERIFY(std::abs(flight.robot.command().yaw_rate_rad_s - yaw_rate_rad_s) < 1e-12);
    }

    void flowsTheWayItLooks() {
        FlightStart spawn = inTheAir({0.0, 0.0, 10.0});
        spawn.base_in_map.yaw_rad = radians(90.0);
        Flight flight(flatWorld(), spawn);
        flight.drive(1.0, 0.0, 0.0);
        flight.run(Seconds{5.0});
        QVERIFY((flight.velocity_m_s() - Vec3(0.0, 1.0, 0.0)).norm() < 0.05);
    }

    void deadBatteryFallsAtTerminalSpeed() {
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 60.0}));
        flight.run(Seconds{2.0});
        flight.robot.switchOff();
        flight.run(Seconds{0.5});
        QCOMPARE(flight.robot.motors(), MotorState::Dead);
        flight.run(Seconds{5.0});
        const AirRobotParameters parameters;
        const double terminal_m_s = std::sqrt(parameters.mass_kg * gravity_m_s2 / parameters.drag_kg_m);
        QVERIFY(std::abs(flight.velocity_m_s().z() + terminal_m_s) < 0.05);
        flight.drive(0.0, 0.0, 2.0);
        flight.run(Seconds{10.0});
        QVERIFY(flight.robot.broken());
        QVERIFY(flight.pose().position_m.z() < 1.0);
    }
};

USAR_TEST(tst_AirRobotFlight)

} // namespace tst_air_robot_flight

#include "tst_air_robot_flight.moc"
