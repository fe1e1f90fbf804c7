#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_articulation {

using namespace usar;
using namespace usar::sim;

namespace {

Pose at(double x_m, double y_m, double z_m) {
    return Pose{{x_m, y_m, z_m}, 0.0, 0.0, 0.0};
}

void run(Physics& physics, Seconds duration) {
    for (long i = std::lround(duration / physics_dt); i > 0; --i)
        physics.step(physics_dt);
}

/// A block so heavy that what hangs on it does not move it, and an arm: a point of 1 kg, 0.5 m from a pivot on the
/// block's side. The arm hangs straight down at joint angle 0; positive angles swing it toward -x.
constexpr double arm_m = 0.5;
constexpr double block_kg = 1e6;
ArticulatedDescription armOnABlock() {
    ArticulatedDescription body;
    body.base = {block_kg, Vec3::Constant(1e6), 0.9, {{BoxShape{{1.0, 1.0, 1.0}}, Pose{}}}};
    LinkDescription arm;
    arm.body = {1.0, Vec3::Constant(1e-6), 0.9, {}};
    arm.link_in_parent = at(0.0, 0.8, 0.4 - arm_m);
    arm.pivot_in_link_m = {0.0, 0.0, arm_m};
    arm.axis_in_link = Vec3::UnitY();
    body.links.push_back(arm);
    return body;
}
constexpr double lifting_n_m = arm_m * gravity_m_s2; ///< what holds the arm level

/// The arm's world: its block hangs in the air, held against its weight.
struct Bench {
    explicit Bench(const ArticulatedDescription& description = armOnABlock())
        : world(flatWorld())
        , physics(makePhysics(world))
        , body(physics->add(description, at(0.0, 0.0, 2.0))) {}

    void step() {
        physics->apply(body, {0.0, 0.0, block_kg * gravity_m_s2}, Vec3::Zero());
        physics->step(physics_dt);
    }
    void run(Seconds duration) {
        for (long i = std::lround(duration / physics_dt); i > 0; --i)
            step();
    }
    void drive(JointMotor::Mode mode, double target, double limit, double largest_speed = 1e9) {
        physics->setMotor(body, 0, {mode, target, limit, largest_speed});
    }
    JointState joint() const { return physics->joint(body, 0); }

    World world;
    std::unique_ptr<Physics> physics;
    BodyId body;
};

/// The joint's angle is its block's as well; brought there by a strong motor that is then let go.
void bringTo(Bench& bench, double angle_rad) {
    bench.drive(JointMotor::Mode::Position, angle_rad, 200.0);
    bench.run(Seconds{2.0});
    bench.drive(JointMotor::Mode::Off, 0.0, 0.0);
}

BodyDescription ball(double restitution, double rolling_friction_m) {
    const double inertia = 0.4 * 0.06 * 0.043 * 0.043;
    return {0.06, Vec3::Constant(inertia), 0.9, {{SphereShape{0.043}, Pose{}}}, restitution, rolling_friction_m};
}

} // namespace

class tst_Articulation : public QObject {
    Q_OBJECT

private slots:
    void fallsAsNewtonSays() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(armOnABlock(), at(0.0, 0.0, 20.0));
        run(*physics, Seconds{1.0});
        const double fallen_m = gravity_m_s2 / 2.0 * (1.0 + physics_dt.count());
        QVERIFY(std::abs(physics->state(body).velocity_m_s.z() + gravity_m_s2) < 1e-6);
        QVERIFY(std::abs(20.0 - fallen_m - physics->state(body).position_m.z()) < 1e-6);
        QVERIFY(std::abs(physics->state(body, 0).velocity_m_s.z() + gravity_m_s2) < 1e-6);
        QVERIFY(std::abs(physics->joint(body, 0).position) < 1e-6);
    }

    void linksAreWhereTheDescriptionPutsThem() {
        Bench bench;
        const Vec3 hanging_m = bench.physics->state(bench.body, 0).position_m;
        QVERIFY((hanging_m - Vec3(0.0, 0.8, 1.9)).norm() < 1e-9);
        bringTo(bench, pi / 2.0);
        const Vec3 level_m = bench.physics->state(bench.body, 0).position_m;
        QVERIFY((level_m - Vec3(-arm_m, 0.8, 2.4)).norm() < 0.001);
    }

    void aPendulumKeepsItsTime() {
        Bench bench;
        bringTo(bench, 0.1);
        std::vector<double> crossings_s;
        double last = bench.joint().position;
        for (double t_s = 0.0; t_s < 20.0; t_s += physics_dt.count()) {
            bench.step();
            const double now = bench.joint().position;
            if (last > 0.0 && now <= 0.0)
                crossings_s.push_back(t_s + physics_dt.count() * last / (last - now));
            last = now;
        }
        QVERIFY(crossings_s.size() > 10);
        const double period_s =
            (crossings_s.back() - crossings_s.front()) / static_cast<double>(crossings_s.size() - 1);
        const double exact_s = 2.0 * pi * std::sqrt(arm_m / gravity_m_s2);
        QVERIFY2(std::abs(period_s / exact_s - 1.0) < 0.005, qPrintable(QString::number(period_s / exact_s)));
    }

    void aPendulumLosesNothingAndGainsNothing() {
        Bench bench;
        bringTo(bench, 0.5);
        double late_rad = 0.0;
        bench.run(Seconds{57.0});
        for (int i = 0; i < 750; ++i) {
            bench.step();
            late_rad = std::max(late_rad, std::abs(bench.joint().position));
        }
        QVERIFY2(std::abs(late_rad - 0.5) < 0.02, qPrintable(QString::number(late_rad)));
    }

    void dampingEatsTheSwing() {
        ArticulatedDescription damped = armOnABlock();
        damped.links[0].damping = 0.05;
        Bench bench(damped);
        bringTo(bench, 0.2);
        const double angle_rad = bench.joint().position;
        const double period_s = 2.0 * pi * std::sqrt(arm_m / gravity_m_s2);
        bench.run(Seconds{5.0 * period_s});
        // Amplitude falls with exp(-d t / 2 m l^2).
        const double expected_rad = angle_rad * std::exp(-0.05 * 5.0 * period_s / (2.0 * arm_m * arm_m));
        QVERIFY2(std::abs(bench.joint().position / expected_rad - 1.0) < 0.1,
                 qPrintable(QString::number(bench.joint().position / expected_rad)));
    }

    void aServoHoldsUpToItsTorqueAndNotBeyond_data() {
        QTest::addColumn<double>("share");
        QTest::addColumn<bool>("holds");
        QTest::newRow("plenty") << 3.0 << true;
        QTest::newRow("a little more than the load") << 1.05 << true;
        QTest::newRow("a little less than the load") << 0.95 << false;
        QTest::newRow("hardly any") << 0.2 << false;
    }
    void aServoHoldsUpToItsTorqueAndNotBeyond() {
        QFETCH(double, share);
        QFETCH(bool, holds);
        Bench bench;
        bringTo(bench, pi / 2.0);
        bench.drive(JointMotor::Mode::Position, pi / 2.0, share * lifting_n_m);
        bench.run(Seconds{10.0});
        const double angle_rad = bench.joint().position;
        QCOMPARE(std::abs(angle_rad - pi / 2.0) < 0.03, holds);
    }

    void aServoGoesNoFasterThanItMay() {
        Bench bench;
        bench.drive(JointMotor::Mode::Position, 2.0, 100.0, 1.0);
        double fastest_rad_s = 0.0;
        for (int i = 0; i < 250; ++i) {
            bench.step();
            fastest_rad_s = std::max(fastest_rad_s, bench.joint().velocity);
        }
        QVERIFY(std::abs(fastest_rad_s - 1.0) < 0.01);
        QVERIFY(std::abs(bench.joint().position - 1.0) < 0.02); // after a second
        bench.run(Seconds{2.0});
        QVERIFY(std::abs(bench.joint().position - 2.0) < 0.01);
    }

    void aVelocityMotorReachesItsSpeed() {
        Bench bench;
        bench.drive(JointMotor::Mode::Velocity, 3.0, 100.0);
        bench.run(Seconds{1.0});
        QVERIFY(std::abs(bench.joint().velocity - 3.0) < 0.01);
        const double before_rad = bench.joint().position;
        bench.run(Seconds{2.0});
        QVERIFY(std::abs(bench.joint().position - before_rad - 6.0) < 0.02);
    }

    void aVelocityMotorAcceleratesByItsTorque() {
        ArticulatedDescription wheel = armOnABlock();
        wheel.links[0].body.inertia_kg_m2 = Vec3::Constant(0.5);
        wheel.links[0].pivot_in_link_m = Vec3::Zero();
        Bench bench(wheel);
        bench.run(Seconds{0.2});
        bench.drive(JointMotor::Mode::Velocity, 100.0, 2.0);
        bench.run(Seconds{1.0});
        QVERIFY(std::abs(bench.joint().velocity - 4.0) < 0.05);
    }

    void aTorqueActsUntilItIsTakenBack() {
        ArticulatedDescription wheel = armOnABlock();
        wheel.links[0].body.inertia_kg_m2 = Vec3::Constant(0.5);
        wheel.links[0].pivot_in_link_m = Vec3::Zero();
        Bench bench(wheel);
        bench.drive(JointMotor::Mode::Torque, 9.0, 2.0);
        bench.run(Seconds{1.0});
        QVERIFY(std::abs(bench.joint().velocity - 4.0) < 0.05);
        bench.drive(JointMotor::Mode::Off, 0.0, 0.0);
        bench.run(Seconds{1.0});
        QVERIFY(std::abs(bench.joint().velocity - 4.0) < 0.05);
    }

    void aTorqueMakesItNoFasterThanItMayGo() {
        Bench bench;
        bench.drive(JointMotor::Mode::Torque, 50.0, 50.0, 6.0);
        for (int i = 0; i < 250; ++i) {
            bench.step();
            QVERIFY(bench.joint().velocity < 6.01);
        }
        QVERIFY(std::abs(bench.joint().velocity - 6.0) < 0.01);
    }

    void aJointStopsAtItsLimits() {
        ArticulatedDescription limited = armOnABlock();
        limited.links[0].lower = -0.4;
        limited.links[0].upper = 0.7;
        Bench bench(limited);
        bench.drive(JointMotor::Mode::Velocity, 2.0, 20.0);
        bench.run(Seconds{2.0});
        QVERIFY2(std::abs(bench.joint().position - 0.7) < 0.03, qPrintable(QString::number(bench.joint().position)));
        bench.drive(JointMotor::Mode::Velocity, -2.0, 20.0);
        bench.run(Seconds{2.0});
        QVERIFY2(std::abs(bench.joint().position + 0.4) < 0.03, qPrintable(QString::number(bench.joint().position)));
    }

    void aSliderSlides() {
        ArticulatedDescription body = armOnABlock();
        body.links[0].kind = JointKind::Prismatic;
        body.links[0].axis_in_link = Vec3::UnitZ();
        Bench bench(body);
        const double before_m = bench.physics->state(bench.body, 0).position_m.z();
        bench.drive(JointMotor::Mode::Position, 0.3, 50.0);
        bench.run(Seconds{1.0});
        QVERIFY(std::abs(bench.joint().position - 0.3) < 0.005);
        QVERIFY(std::abs(bench.physics->state(bench.body, 0).position_m.z() - before_m - 0.3) < 0.01);
    }

    void contactsNameTheLinkAndTheWayOut() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        ArticulatedDescription wheel;
        wheel.base = {1.0, Vec3::Constant(0.01), 0.9, {{BoxShape{{0.2, 0.2, 0.2}}, Pose{}}}};
        LinkDescription link;
        link.body = {1.0, Vec3::Constant(0.01), 0.9, {{SphereShape{0.1}, Pose{}}}};
        link.link_in_parent = at(0.0, 0.0, -0.3);
        wheel.links.push_back(link);
        const BodyId body = physics->add(wheel, at(0.2, 0.2, 0.5));
        QVERIFY(!physics->isStuck(body));
        for (int i = 0; i < 100 && physics->contacts(body).empty(); ++i)
            physics->step(physics_dt);
        const Contact contact = physics->contacts(body).front();
        QCOMPARE(contact.link, 0);
        QCOMPARE(contact.surface, Surface::Ground);
        QVERIFY((contact.normal_in_map - Vec3::UnitZ()).norm() < 1e-6);
        QVERIFY((contact.point_in_body_m - Vec3(0.0, 0.0, -0.1)).norm() < 0.01);
        QVERIFY(std::abs(contact.closing_speed_m_s - std::sqrt(2.0 * gravity_m_s2 * 0.1)) < 0.1);
        physics->place(body, at(0.2, 0.2, 0.35));
        QVERIFY(physics->isStuck(body));
    }

    void raysSeeLinks() {
        ArticulatedDescription body = armOnABlock();
        body.links[0].body.parts = {{SphereShape{0.1}, Pose{}}};
        Bench bench(body);
        const BodyId none{};
        QVERIFY(std::abs(bench.physics->castAtBodies({3.0, 0.8, 1.9}, -Vec3::UnitX(), 5.0, 5.0, none) - 2.9) < 1e-6);
        QCOMPARE(bench.physics->castAtBodies({3.0, 0.8, 1.9}, -Vec3::UnitX(), 5.0, 5.0, bench.body), 5.0);
        QVERIFY(std::abs(bench.physics->distanceToBodies_m({3.0, 0.0, 2.0}, none) - 3.0) < 1e-9);
        bench.physics->remove(bench.body);
        QCOMPARE(bench.physics->castAtBodies({3.0, 0.8, 1.9}, -Vec3::UnitX(), 5.0, 5.0, none), 5.0);
        bench.physics->step(physics_dt);
    }

    void forcesOnTheBaseMoveTheWhole() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        ArticulatedDescription pair = armOnABlock();
        pair.base.mass_kg = 3.0;
        pair.links[0].kind = JointKind::Prismatic; // along y: it follows in x and z
        const BodyId body = physics->add(pair, at(0.0, 0.0, 50.0));
        for (int i = 0; i < 250; ++i) {
            physics->apply(body, {8.0, 0.0, 4.0 * gravity_m_s2}, Vec3::Zero());
            physics->step(physics_dt);
        }
        QVERIFY((physics->state(body).velocity_m_s - Vec3(2.0, 0.0, 0.0)).norm() < 0.01);
        QVERIFY((physics->state(body, 0).velocity_m_s - Vec3(2.0, 0.0, 0.0)).norm() < 0.01);
    }

    void sleepsOnlyWhereAllowedAndWakesWhenHit() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        ArticulatedDescription box = armOnABlock();
        box.base.mass_kg = 10.0;
        box.base.inertia_kg_m2 = Vec3::Constant(1.7);
        box.base.parts.clear();
        for (const double x_m : {-0.4, 0.4})
            for (const double y_m : {-0.4, 0.4})
                box.base.parts.push_back({SphereShape{0.1}, at(x_m, y_m, -0.4)});
        const BodyId body = physics->add(box, at(0.1, 0.1, 0.5));
        physics->setMotor(body, 0, {JointMotor::Mode::Velocity, 0.0, 10.0});
        run(*physics, Seconds{1.0});
        physics->letSleep(body, true);
        run(*physics, Seconds{4.0});
        const Vec3 asleep_m = physics->state(body).position_m;
        run(*physics, Seconds{20.0});
        QCOMPARE(physics->state(body).position_m, asleep_m);
        physics->add(ball(0.0, 0.0), at(0.52, 0.5, 3.0)); // on a foot
        run(*physics, Seconds{2.0});
        QVERIFY(physics->state(body).position_m != asleep_m);
        physics->letSleep(body, false);
        physics->setMotor(body, 0, {JointMotor::Mode::Position, 0.3, 10.0});
        run(*physics, Seconds{1.0});
        QVERIFY(std::abs(physics->joint(body, 0).position - 0.3) < 0.02);
    }

    void aBallRollsOutAgainstItsRollingFriction_data() {
        QTest::addColumn<double>("rolling_friction_m");
        QTest::newRow("carpet") << 0.002;
        QTest::newRow("lawn") << 0.006;
    }
    void aBallRollsOutAgainstItsRollingFriction() {
        QFETCH(double, rolling_friction_m);
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(0.0, rolling_friction_m), at(0.2, 0.2, 0.043));
        for (int i = 0; i < 10; ++i) { // a push through the center, which friction turns into rolling
            physics->apply(body, {0.06 * 1.4 / 0.04, 0.0, 0.0}, Vec3::Zero());
            physics->step(physics_dt);
        }
        run(*physics, Seconds{0.2});
        const BodyState rolling = physics->state(body);
        const double speed_m_s = rolling.velocity_m_s.x();
        QVERIFY(std::abs(rolling.rate_rad_s.y() * 0.043 / speed_m_s - 1.0) < 0.05);
        run(*physics, Seconds{20.0});
        // The torque c N slows m + I / r^2 = 1.4 m by c N / r.
        const double braking_m_s2 = rolling_friction_m / 0.043 * gravity_m_s2 / 1.4;
        const double expected_m = speed_m_s * speed_m_s / (2.0 * braking_m_s2);
        const double rolled_m = physics->state(body).position_m.x() - rolling.position_m.x();
        QVERIFY2(std::abs(rolled_m / expected_m - 1.0) < 0.1, qPrintable(QString::number(rolled_m / expected_m)));
        QVERIFY(physics->state(body).velocity_m_s.norm() < 0.01);
    }

    void aBallBouncesByItsRestitution_data() {
        QTest::addColumn<double>("restitution");
        QTest::addColumn<double>("from_m");
        QTest::newRow("soccer ball") << 0.6 << 1.0;
        QTest::newRow("soccer ball from high up") << 0.6 << 3.3;
        QTest::newRow("rubber ball") << 0.9 << 1.0;
        QTest::newRow("bean bag") << 0.0 << 1.0;
    }
    void aBallBouncesByItsRestitution() {
        QFETCH(double, restitution);
        QFETCH(double, from_m);
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(restitution, 0.0), at(0.2, 0.1, from_m + 0.043));
        while (physics->contacts(body).empty())
            physics->step(physics_dt);
        double top_m = 0.0;
        do {
            top_m = std::max(top_m, physics->state(body).position_m.z() - 0.043);
            physics->step(physics_dt);
        } while (physics->contacts(body).empty() && physics->state(body).velocity_m_s.z() > -0.5);
        const double expected_m = restitution * restitution * from_m;
        QVERIFY2(std::abs(top_m - expected_m) < 0.05 * expected_m + 0.01, qPrintable(QString::number(top_m)));
    }

    void repeatsItselfBitByBit() {
        const auto swing = [] {
            Bench bench;
            bench.drive(JointMotor::Mode::Velocity, 3.0, 4.0);
            bench.physics->add(ball(0.6, 0.002), at(-0.5, 0.8, 3.0));
            bench.run(Seconds{3.0});
            bench.drive(JointMotor::Mode::Position, 0.3, 20.0);
            bench.run(Seconds{3.0});
            const BodyState arm = bench.physics->state(bench.body, 0);
            return std::vector<double>{arm.position_m.x(), arm.position_m.y(), arm.position_m.z(),
                                       bench.joint().velocity};
        };
        QCOMPARE(swing(), swing());
    }
};

USAR_TEST(tst_Articulation)

} // namespace tst_articulation

#include "tst_articulation.moc"
