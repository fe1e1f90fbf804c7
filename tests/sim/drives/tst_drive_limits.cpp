// What drives make of numbers that are too large or no numbers, and of models that lack something.
#include <algorithm>
#include <cmath>
#include <limits>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/drives/nautic_drive.h"
#include "core/sim/robots/drive.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_drive_limits {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

RobotModel modelWith(const std::string& kind, std::vector<std::string> joints = {}, Numbers numbers = {}) {
    RobotModel model;
    model.class_name = "Toy";
    model.drive = {kind, std::move(joints), std::move(numbers)};
    for (const char* const joint : {"A", "B", "C", "D"}) {
        model.links.push_back({.name = joint, .joint = joint, .torque_limit = 5.0, .speed_limit = 10.0});
        model.body.links.push_back({.body = {}, .link_in_parent = {}});
    }
    return model;
}

/// A submarine deep in a lake, with its drive.
struct Submarine {
    World world = lake();
    std::unique_ptr<Physics> physics = makePhysics(world);
    RobotModel model;
    BodyId body;
    NauticDrive drive;

    explicit Submarine(Numbers numbers = {})
        : model(hull(std::move(numbers)))
        , body(physics->add(model.body.base, {.position_m = {0.0, 0.0, 15.0}}))
        , drive(model, *physics, body, world) {}

    static RobotModel hull(Numbers numbers) {
        RobotModel model;
        model.drive.numbers = std::move(numbers);
        model.body.base.mass_kg = 30.0;
        model.body.base.inertia_kg_m2 = {0.2, 3.5, 3.5};
        model.body.base.parts = {{CapsuleShape{0.095, 1.4}, {.pitch_rad = pi / 2.0}}};
        return model;
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            drive.beforeStep(physics_dt);
            physics->step(physics_dt);
            drive.afterStep(physics_dt);
        }
    }
    double angle_rad(const std::string& name) const {
        protocol::RobotState state;
        drive.addState(state);
        for (const protocol::JointAngle& joint : state.joints)
            if (joint.name == name)
                return joint.angle_rad;
        return nan;
    }
};

} // namespace

class tst_DriveLimits : public QObject {
    Q_OBJECT

private slots:
    void aTermIsLimited_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<bool>("normalized");
        QTest::addColumn<double>("limited");
        QTest::newRow("within") << 1.5 << false << 1.5;
        QTest::newRow("zero") << 0.0 << false << 0.0;
        QTest::newRow("too much") << 4.5 << false << 4.0;
        QTest::newRow("too much backward") << -4.5 << false << -4.0;
        QTest::newRow("endless") << inf << false << 4.0;
        QTest::newRow("endless backward") << -inf << false << -4.0;
        QTest::newRow("no number") << nan << false << 0.0;
        QTest::newRow("half of all") << 50.0 << true << 2.0;
        QTest::newRow("all backward") << -100.0 << true << -4.0;
        QTest::newRow("more than all") << 250.0 << true << 4.0;
        QTest::newRow("no number of percent") << nan << true << 0.0;
        QTest::newRow("endlessly many percent") << inf << true << 4.0;
    }
    void aTermIsLimited() {
        QFETCH(const double, value);
        QFETCH(const bool, normalized);
        QFETCH(const double, limited);
        QCOMPARE(sim::limited(value, 4.0, normalized), limited);
        double taken = 1.25;
        takeTerm(std::nullopt, 4.0, normalized, taken);
        QCOMPARE(taken, 1.25); // what is left out stays
        takeTerm(value, 4.0, normalized, taken);
        QCOMPARE(taken, limited);
        QCOMPARE(sim::limited(value, 0.0, normalized), 0.0); // what cannot move stands
    }

    void figuresOfAModelReplaceTheUsualOnes() {
        const HullFigures hull{{{"fin_lift", 3.0}, {"rudder_limit", 0.5}, {"hull", 9.0}}};
        QCOMPARE(hull.fin_lift_kg_m, 3.0);
        QCOMPARE(hull.rudder_limit_rad, 0.5);
        QCOMPARE(hull.stern_plane_limit_rad, HullFigures{}.stern_plane_limit_rad);
        QCOMPARE(hull.radius_m, HullFigures{}.radius_m);
        const AirRobotParameters parameters{{{"rotor_lag", 0.2}, {"pod_width", 0.4}, {"tilt_limit", 0.1}}, 1.5};
        QCOMPARE(parameters.mass_kg, 1.5);
        QCOMPARE(parameters.rotor_lag.count(), 0.2);
        QCOMPARE(parameters.pod_width_m, 0.4);
        QCOMPARE(parameters.tilt_limit_rad, 0.1);
        QCOMPARE(parameters.climb_limit_m_s, AirRobotParameters{}.climb_limit_m_s);
    }

    void aFlyersTermsAreLimited_data() {
        QTest::addColumn<double>("term");
        QTest::addColumn<bool>("normalized");
        QTest::addColumn<VelocityCommand>("command");
        QTest::newRow("within") << 1.0 << false << VelocityCommand{1.0, 1.0, 1.0, 1.0};
        QTest::newRow("too much") << 50.0 << false << VelocityCommand{2.0, 2.0, 2.0, 1.745};
        QTest::newRow("too much backward") << -inf << false << VelocityCommand{-2.0, -2.0, -2.0, -1.745};
        QTest::newRow("no number") << nan << false << VelocityCommand{};
        QTest::newRow("percent") << 50.0 << true << VelocityCommand{1.0, 1.0, 1.0, 0.8725};
        QTest::newRow("more than all") << 1000.0 << true << VelocityCommand{2.0, 2.0, 2.0, 1.745};
    }
    void aFlyersTermsAreLimited() {
        QFETCH(const double, term);
        QFETCH(const bool, normalized);
        QFETCH(const VelocityCommand, command);
        Flight flight(flatWorld(), inTheAir({0.0, 0.0, 10.0}));
        QVERIFY(flight.robot.obey(protocol::Command(protocol::AerialDrive{term, term, term, term, normalized})));
        QVERIFY(flight.robot.command() == command);
        QVERIFY(flight.robot.obey(protocol::Command(protocol::AerialDrive{.normalized = normalized})));
        QVERIFY(flight.robot.command() == command); // absent terms stay
        QVERIFY(!flight.robot.obey(protocol::Command(protocol::SkidDrive{.left_rad_s = term})));
        flight.run(Seconds{1.0});
        QVERIFY(flight.pose().position_m.allFinite());
    }

    void rotorsBeyondTheFourAreTheNearest() {
        for (const int rotor : {-5, 0, 1, 4, 5, 100}) {
            Flight flight(flatWorld(), inTheAir({0.0, 0.0, 10.0}));
            flight.robot.weakenRotor(rotor, 0.0);
            double lowest_up_z = 1.0;
            flight.run(Seconds{1.0}, [&](Seconds) {
                lowest_up_z = std::min(lowest_up_z, flight.robot.state().rotation.toRotationMatrix()(2, 2));
            });
            QVERIFY2(lowest_up_z < 0.8, qPrintable(QString::number(rotor))); // it turns over with any of them
        }
    }

    void finsStopAtTheirLimits_data() {
        QTest::addColumn<double>("term");
        QTest::addColumn<bool>("normalized");
        QTest::addColumn<double>("rudder_rad");
        QTest::addColumn<double>("stern_plane_rad");
        QTest::newRow("within") << 0.1 << false << 0.1 << 0.1;
        QTest::newRow("too far") << 3.0 << false << 0.2 << 0.35;
        QTest::newRow("endless the other way") << -inf << false << -0.2 << -0.35;
        QTest::newRow("no number") << nan << false << 0.0 << 0.0;
        QTest::newRow("half") << 50.0 << true << 0.1 << 0.175;
        QTest::newRow("more than all") << -900.0 << true << -0.2 << -0.35;
    }
    void finsStopAtTheirLimits() {
        QFETCH(const double, term);
        QFETCH(const bool, normalized);
        QFETCH(const double, rudder_rad);
        QFETCH(const double, stern_plane_rad);
        Submarine submarine(Numbers{{"rudder_limit", 0.2}});
        QVERIFY(submarine.drive.idle());
        QVERIFY(submarine.drive.obey(protocol::Command(
            protocol::NauticDrive{.rudder_rad = term, .stern_plane_rad = term, .normalized = normalized})));
        submarine.run(25); // a tenth of a second at 1 rad/s
        QVERIFY(std::abs(submarine.angle_rad("RudderAngle")) <= 0.1 + 1e-9);
        QVERIFY(std::abs(submarine.angle_rad("SternPlaneAngle")) <= 0.1 + 1e-9);
        submarine.run(75);
        QVERIFY(std::abs(submarine.angle_rad("RudderAngle") - rudder_rad) < 1e-9);
        QVERIFY(std::abs(submarine.angle_rad("SternPlaneAngle") - stern_plane_rad) < 1e-9);
        QVERIFY(submarine.drive.idle()); // fins alone push nothing
        QVERIFY(submarine.physics->state(submarine.body).position_m.allFinite());
    }

    void aPropellerPushesNoHarderThanItsLimit() {
        const auto speedWith = [](double propeller_rad_s, bool normalized) {
            Submarine submarine;
            submarine.drive.obey(
                protocol::Command(protocol::NauticDrive{.propeller_rad_s = propeller_rad_s, .normalized = normalized}));
            submarine.run(2000);
            return submarine.physics->state(submarine.body).velocity_m_s.x();
        };
        const double full_m_s = speedWith(160.0, false);
        QVERIFY2(full_m_s > 0.5, qPrintable(QString::number(full_m_s)));
        for (const double more : {161.0, 1e6, inf})
            QCOMPARE(speedWith(more, false), full_m_s);
        QCOMPARE(speedWith(100.0, true), full_m_s);
        QVERIFY(speedWith(-160.0, false) < -0.5);
        QCOMPARE(speedWith(nan, false), speedWith(0.0, false));
    }

    void anEmptyBatteryStopsThePropeller() {
        Submarine submarine;
        submarine.drive.obey(protocol::Command(protocol::NauticDrive{.propeller_rad_s = 100.0}));
        QVERIFY(!submarine.drive.idle());
        submarine.drive.switchOff();
        QVERIFY(submarine.drive.idle());
    }

    void otherVehiclesCommandsAreRefused() {
        Submarine submarine;
        QVERIFY(!submarine.drive.obey(protocol::Command(protocol::SkidDrive{.left_rad_s = 1.0})));
        QVERIFY(!submarine.drive.obey(protocol::Command(protocol::AerialDrive{.climb_m_s = 1.0})));
        QVERIFY(!submarine.drive.broken());
    }

    void namesWhatAModelLacks_data() {
        QTest::addColumn<RobotModel>("model");
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("mend");
        const QString kinds = "Known are rotors, skid, ackermann, omni, nautic, legs and none";
        QTest::newRow("no kind") << modelWith("") << "there is no drive of the kind \"\"" << kinds;
        QTest::newRow("an unknown kind") << modelWith("wings") << "there is no drive of the kind \"wings\"" << kinds;
        QTest::newRow("a kind in another case")
            << modelWith("Skid") << "there is no drive of the kind \"Skid\"" << kinds;
        const QString pairs = "Name the left wheels' joints and then as many right ones";
        QTest::newRow("no wheel") << modelWith("skid") << "a skid drive has 0 joints" << pairs;
        QTest::newRow("one wheel") << modelWith("skid", {"A"}) << "a skid drive has 1 joints" << pairs;
        QTest::newRow("three wheels") << modelWith("skid", {"A", "B", "C"}) << "a skid drive has 3 joints" << pairs;
        const QString existing = "Name one of the model's joints";
        QTest::newRow("a wheel that is not there")
            << modelWith("skid", {"A", "E"}) << "the drive's joint \"E\" does not exist" << existing;
        QTest::newRow("a leg that is not there")
            << modelWith("legs", {"A", "Knee"}) << "the drive's joint \"Knee\" does not exist" << existing;
        QTest::newRow("a steered wheel that is not there")
            << modelWith("ackermann", {"F", "A"}) << "the drive's joint \"F\" does not exist" << existing;
        const QString steered = "an ackermann drive needs driven joints and steered ones";
        const QString name = "Name the driven joints, then the steered ones, and say in `steered` how many these are";
        QTest::newRow("steered wheels only") << modelWith("ackermann", {"A", "B"}) << steered << name;
        QTest::newRow("no steered wheel")
            << modelWith("ackermann", {"A", "B", "C"}, {{"steered", 0.0}}) << steered << name;
        QTest::newRow("more steered wheels than wheels")
            << modelWith("ackermann", {"A", "B", "C"}, {{"steered", 4.0}}) << steered << name;
        QTest::newRow("steered wheels in no number")
            << modelWith("ackermann", {"A", "B", "C"}, {{"steered", nan}}) << steered << name;
        const QString base = "an ackermann drive has no wheel_base";
        QTest::newRow("no wheel base") << modelWith("ackermann", {"A", "B", "C"}) << base
                                       << "Give the distance of its axles in meters";
        QTest::newRow("a wheel base below zero") << modelWith("ackermann", {"A", "B", "C"}, {{"wheel_base", -0.3}})
                                                 << base << "Give the distance of its axles in meters";
    }
    void namesWhatAModelLacks() {
        QFETCH(const RobotModel, model);
        QFETCH(const QString, what);
        QFETCH(const QString, mend);
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const auto drive = makeDrive(model, *physics, BodyId{1}, world, {});
        QVERIFY(!drive);
        QCOMPARE(QString::fromStdString(drive.error().what), what);
        QCOMPARE(drive.error().where, std::string("robot Toy"));
        QCOMPARE(QString::fromStdString(drive.error().mend), mend);
    }
};

USAR_TEST(tst_DriveLimits)

} // namespace tst_drive_limits

#include "tst_drive_limits.moc"
