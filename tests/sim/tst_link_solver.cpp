// Robots on wheels against formulas, and against Bullet's own solver, which has them while they touch a crate.
#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_link_solver {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr double wheel_m = 0.1; ///< radius
constexpr double wheel_kg = 0.5;
constexpr double wheel_kg_m2 = 0.5 * wheel_kg * wheel_m * wheel_m; ///< about the axle, of a disc
constexpr double base_kg = 10.0;
constexpr double cart_kg = base_kg + 4.0 * wheel_kg;
constexpr double friction = 0.8;
constexpr std::size_t wheels = 4;

LinkDescription wheel(double x_m, double y_m) {
    LinkDescription link;
    link.body = {wheel_kg,
                 Vec3(wheel_kg_m2 / 2.0, wheel_kg_m2, wheel_kg_m2 / 2.0),
                 friction,
                 {{CylinderShape{wheel_m, 0.04}, Pose{Vec3::Zero(), pi / 2.0, 0.0, 0.0}}}};
    link.link_in_parent = Pose{{x_m, y_m, -0.1}, 0.0, 0.0, 0.0};
    link.axis_in_link = Vec3::UnitY();
    return link;
}

ArticulatedDescription cart() {
    ArticulatedDescription body;
    body.base = {base_kg, Vec3(0.2, 0.4, 0.5), friction, {{BoxShape{{0.8, 0.5, 0.1}}, Pose{}}}};
    for (const double x_m : {0.2, -0.2})
        for (const double y_m : {0.3, -0.3})
            body.links.push_back(wheel(x_m, y_m));
    return body;
}

/// The same cart with a splinter on its roof, which is no wheel, so that each step begins without impulses.
ArticulatedDescription cartWithALimb() {
    ArticulatedDescription body = cart();
    LinkDescription splinter;
    splinter.body = {1e-4, Vec3::Constant(1e-9), friction, {{BoxShape{{0.01, 0.01, 0.01}}, Pose{}}}};
    splinter.link_in_parent = Pose{{0.0, 0.0, 0.2}, 0.0, 0.0, 0.0};
    splinter.axis_in_link = Vec3::UnitZ();
    body.links.push_back(splinter);
    return body;
}

/// The same cart with a fence on its roof, for a crate that weighs a gram: it makes Bullet's solver do the work.
ArticulatedDescription cartWithAFence() {
    ArticulatedDescription body = cart();
    for (const double side : {-1.0, 1.0}) {
        body.base.parts.push_back({BoxShape{{0.2, 0.02, 0.1}}, Pose{{0.0, side * 0.04, 0.1}, 0.0, 0.0, 0.0}});
        body.base.parts.push_back({BoxShape{{0.02, 0.2, 0.1}}, Pose{{side * 0.04, 0.0, 0.1}, 0.0, 0.0, 0.0}});
    }
    return body;
}

const BodyDescription crate{0.001, Vec3::Constant(4e-7), friction, {{BoxShape{{0.05, 0.05, 0.05}}, Pose{}}}};

struct Drive {
    explicit Drive(World ground, const ArticulatedDescription& description = cart(), double z_m = 0.2)
        : world(std::move(ground))
        , physics(makePhysics(world))
        , body(physics->add(description, Pose{{0.0, 0.0, z_m}, 0.0, 0.0, 0.0})) {}

    void run(Seconds duration) {
        for (long i = std::lround(duration / physics_dt); i > 0; --i)
            physics->step(physics_dt);
    }
    /// Wheels 0 and 2 are those on the left.
    void drive(JointMotor::Mode mode, double left, double right, double limit) {
        for (std::size_t i = 0; i < wheels; ++i)
            physics->setMotor(body, i, {mode, i % 2 == 0 ? left : right, limit});
    }
    Vec3 position_m() const { return physics->state(body).position_m; }
    /// How far from the ground's surface the farthest of the points lies at which the ground presses.
    double farthestPress_m() const {
        double farthest_m = 0.0;
        for (const Contact& contact : physics->contacts(body)) {
            const BodyState touched =
                contact.link < 0 ? physics->state(body) : physics->state(body, static_cast<std::size_t>(contact.link));
            const Vec3 at_m = touched.position_m + touched.rotation * contact.point_in_body_m;
            if (contact.surface == Surface::Ground)
                farthest_m = std::max(farthest_m, std::abs(at_m.z() - world.terrain.height_m(at_m.head<2>())));
        }
        return farthest_m;
    }
    double speed_m_s() const { return physics->state(body).velocity_m_s.norm(); }

    World world;
    std::unique_ptr<Physics> physics;
    BodyId body;
};

bool near(double value, double wanted, double share) {
    return std::abs(value - wanted) <= share * std::abs(wanted);
}

QByteArray words(double value, double wanted) {
    return QStringLiteral("%1 instead of %2").arg(value).arg(wanted).toUtf8();
}

} // namespace

class tst_LinkSolver : public QObject {
    Q_OBJECT

private slots:
    // The wheels' inertia counts as more mass.
    void torquePushesAsNewtonSays() {
        Drive cart(flatWorld());
        cart.run(Seconds{1.0});
        constexpr double torque_n_m = 0.5;
        cart.drive(JointMotor::Mode::Torque, torque_n_m, torque_n_m, torque_n_m);
        cart.run(Seconds{1.0});
        const double wanted = 4.0 * torque_n_m / wheel_m / (cart_kg + 4.0 * wheel_kg_m2 / (wheel_m * wheel_m));
        QVERIFY2(near(cart.speed_m_s(), wanted, 0.01), words(cart.speed_m_s(), wanted));
    }

    void lockedWheelsSlideAsFrictionSays() {
        Drive cart(flatWorld());
        constexpr double speed_m_s = 2.0;
        cart.drive(JointMotor::Mode::Velocity, speed_m_s / wheel_m, speed_m_s / wheel_m, 2.0);
        cart.run(Seconds{3.0});
        QVERIFY2(near(cart.speed_m_s(), speed_m_s, 0.01), words(cart.speed_m_s(), speed_m_s));
        const double began_m = cart.position_m().x();
        cart.drive(JointMotor::Mode::Velocity, 0.0, 0.0, 1000.0);
        cart.run(Seconds{2.0});
        const double wanted_m = speed_m_s * speed_m_s / (2.0 * friction * gravity_m_s2);
        QVERIFY2(near(cart.position_m().x() - began_m, wanted_m, 0.05),
                 words(cart.position_m().x() - began_m, wanted_m));
        QVERIFY(cart.speed_m_s() < 1e-3);
    }

    void brakesHoldOnASlopeUpToTheAngleOfFriction_data() {
        QTest::addColumn<double>("slope_deg");
        QTest::addColumn<bool>("holds");
        QTest::newRow("30 degrees") << 30.0 << true; // arctan 0.8 is 38.7 degrees
        QTest::newRow("36 degrees") << 36.0 << true;
        QTest::newRow("42 degrees") << 42.0 << false;
    }

    void brakesHoldOnASlopeUpToTheAngleOfFriction() {
        QFETCH(double, slope_deg);
        QFETCH(bool, holds);
        const double slope_rad = radians(slope_deg);
        World slope = slopeWorld(slope_rad);
        const auto physics = makePhysics(slope);
        const Vec3 start_m = 0.205 * Vec3(-std::sin(slope_rad), 0.0, std::cos(slope_rad));
        const BodyId body = physics->add(cart(), Pose{start_m, 0.0, -slope_rad, 0.0});
        const auto run = [&](double seconds) {
            for (long i = std::lround(Seconds{seconds} / physics_dt); i > 0; --i)
                physics->step(physics_dt);
        };
        for (std::size_t i = 0; i < wheels; ++i)
            physics->setMotor(body, i, {JointMotor::Mode::Velocity, 0.0, 1000.0});
        run(0.5);
        const Vec3 settled_m = physics->state(body).position_m;
        run(1.0);
        const double slid_m = (physics->state(body).position_m - settled_m).norm();
        QVERIFY2(holds ? slid_m < 0.002 : slid_m > 0.1, qPrintable(QString::number(slid_m)));
    }

    void aCrashKeepsTheMomentum() {
        Drive one(flatWorld());
        const BodyId other = one.physics->add(cart(), Pose{{2.0, 0.0, 0.2}, 0.0, 0.0, 0.0});
        one.drive(JointMotor::Mode::Velocity, 10.0, 10.0, 2.0);
        double before = 0.0;
        for (int i = 0; i < 1500 && one.physics->state(other).velocity_m_s.x() < 0.1; ++i) {
            before = one.physics->state(one.body).velocity_m_s.x();
            one.drive(JointMotor::Mode::Off, 0.0, 0.0, 0.0);
            if (one.position_m().x() < 0.8)
                one.drive(JointMotor::Mode::Velocity, 10.0, 10.0, 2.0);
            one.physics->step(physics_dt);
        }
        one.drive(JointMotor::Mode::Off, 0.0, 0.0, 0.0);
        one.run(Seconds{0.2});
        const double after = one.physics->state(one.body).velocity_m_s.x() + one.physics->state(other).velocity_m_s.x();
        QVERIFY2(before > 0.9 && near(after, before, 0.05), words(after, before));
    }

    // Ground beside a part may be as high as its belly while the ground beneath lies deeper. It was once taken for all
    // the ground around, and the robot hung in the air.
    void nothingPressesButTheGround() {
        const World meadow = makeTallTest(1);
        ArticulatedDescription low = cart();
        low.base.parts = {{BoxShape{{0.5, 0.28, 0.1}}, Pose{{0.0, 0.0, -0.09}, 0.0, 0.0, 0.0}}};
        std::size_t presses = 0;
        for (double side_rad = 0.0; side_rad < 2.0 * pi; side_rad += pi / 6.0) {
            const Vec2 start_m = 8.0 * Vec2(std::cos(side_rad), std::sin(side_rad));
            const double z_m = meadow.terrain.height_m(start_m) + 0.4;
            Drive drive(meadow, low);
            drive.physics->place(drive.body, Pose{{start_m.x(), start_m.y(), z_m}, 0.0, 0.0, side_rad + pi});
            drive.run(Seconds{1.0});
            drive.drive(JointMotor::Mode::Velocity, 8.0, 8.0, 10.0);
            for (int i = 0; i < 4000; ++i) {
                drive.run(physics_dt);
                presses += drive.physics->contacts(drive.body).size();
                QVERIFY2(drive.farthestPress_m() < 0.02, words(drive.farthestPress_m(), 0.0));
            }
        }
        QVERIFY(presses > 100000);
    }

    void aLimbOrACrateMakesNoDifference_data() {
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("right");
        QTest::addColumn<double>("slope_deg");
        QTest::newRow("straight on") << 8.0 << 8.0 << 0.0;
        QTest::newRow("up a ramp") << 8.0 << 8.0 << 15.0;
        QTest::newRow("a bend") << 6.0 << 9.0 << 0.0;
        QTest::newRow("on the spot") << -6.0 << 6.0 << 0.0;
    }

    /// Bends need not agree so well: turning slips, without the impulses of the last step the cart creeps aside, and
    /// the crate rattles.
    void aLimbOrACrateMakesNoDifference() {
        QFETCH(double, left);
        QFETCH(double, right);
        QFETCH(double, slope_deg);
        const auto drive = [&](const ArticulatedDescription& description, bool with_crate) {
            Drive run(slopeWorld(radians(slope_deg)), description, 0.3);
            if (with_crate)
                run.physics->add(crate, Pose{{0.0, 0.0, 0.38}, 0.0, 0.0, 0.0});
            run.drive(JointMotor::Mode::Velocity, 0.0, 0.0, 1000.0);
            run.run(Seconds{1.0});
            run.drive(JointMotor::Mode::Velocity, left, right, 10.0);
            run.run(Seconds{4.0});
            return run.physics->state(run.body);
        };
        const BodyState ours = drive(cart(), false);
        const bool straight = left == right;
        for (const BodyState& other : {drive(cartWithALimb(), false), drive(cartWithAFence(), true)}) {
            const double apart_m = (ours.position_m - other.position_m).norm();
            const double turned_rad = ours.rotation.angularDistance(other.rotation);
            QVERIFY2(apart_m < (straight ? 0.025 : 0.35), qPrintable(QString::number(apart_m)));
            QVERIFY2(turned_rad < (straight ? 0.01 : 0.3), qPrintable(QString::number(turned_rad)));
        }
    }
};

USAR_TEST(tst_LinkSolver)

} // namespace tst_link_solver

#include "tst_link_solver.moc"
