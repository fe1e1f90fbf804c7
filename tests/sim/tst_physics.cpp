#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_physics {

using namespace usar;
using namespace usar::sim;

namespace {

BodyDescription ball(double radius_m = 0.05) {
    return {1.0, Vec3::Constant(0.001), 0.9, {{CapsuleShape{radius_m, 0.001}, Pose{}}}};
}

Pose at(double x_m, double y_m, double z_m) {
    return Pose{{x_m, y_m, z_m}, 0.0, 0.0, 0.0};
}

void run(Physics& physics, Seconds duration) {
    for (long i = std::lround(duration / physics_dt); i > 0; --i)
        physics.step(physics_dt);
}

World furnishedWorld() {
    World world = flatWorld();
    world.plants.push_back({{5.0, 0.0, 0.0}, 0.3, 4.0, CrownShape::Sphere, 1.5, 0.0});
    world.plants.push_back({{-5.0, 0.0, 0.0}, 0.3, 2.0, CrownShape::Cone, 1.0, 3.0});
    world.boxes.push_back({at(0.0, 6.0, 1.0), {2.0, 2.0, 2.0}});
    return world;
}

/// Place, rotation, velocity and rate of turn.
std::vector<double> bitsOf(const BodyState& state) {
    std::vector<double> bits(state.rotation.coeffs().begin(), state.rotation.coeffs().end());
    for (const Vec3& vector : {state.position_m, state.velocity_m_s, state.rate_rad_s})
        bits.insert(bits.end(), vector.begin(), vector.end());
    return bits;
}

} // namespace

class tst_Physics : public QObject {
    Q_OBJECT

private slots:
    void fallsAsNewtonSays() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(), at(0.0, 0.0, 20.0));
        run(*physics, Seconds{1.0});
        const BodyState state = physics->state(body);
        QVERIFY(std::abs(state.velocity_m_s.z() + gravity_m_s2) < 1e-9);
        // The engine moves by the velocity at the end of each step: half a step more than the parabola.
        const double fallen_m = gravity_m_s2 / 2.0 * (1.0 + physics_dt.count());
        QVERIFY(std::abs(20.0 - fallen_m - state.position_m.z()) < 1e-9);
    }

    void forcesActOnceAndAddUp() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(), at(0.0, 0.0, 20.0));
        physics->apply(body, {3.0, 0.0, 0.0}, Vec3::Zero());
        physics->apply(body, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.001});
        run(*physics, Seconds{0.4});
        const BodyState state = physics->state(body);
        QVERIFY(std::abs(state.velocity_m_s.x() - 5.0 * physics_dt.count()) < 1e-12);
        QVERIFY(std::abs(state.rate_rad_s.z() - physics_dt.count()) < 1e-9);
    }

    void standsOnTheTriangleThatTheTerrainNames_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::newRow("below the diagonal") << 0.3 << 0.1;
        QTest::newRow("above the diagonal") << 0.1 << 0.3;
        QTest::newRow("on the diagonal") << 0.25 << 0.25;
        QTest::newRow("far corner") << -31.7 << 31.6;
    }
    void standsOnTheTriangleThatTheTerrainNames() {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        // A saddle in every cell: the two ways to split it differ by 0.15 m in its middle.
        const World world = groundOf([](const Vec2& p) {
            return std::lround(p.x() * 2.0) % 2 != 0 && std::lround(p.y() * 2.0) % 2 == 0 ? 0.3 : 0.0;
        });
        const auto physics = makePhysics(world);
        const double ground_m = world.terrain.height_m({x_m, y_m});
        const BodyId body = physics->add(ball(), at(x_m, y_m, 2.0));
        physics->place(body, at(x_m, y_m, ground_m + 0.12));
        QVERIFY(!physics->isStuck(body));
        physics->place(body, at(x_m, y_m, ground_m + 0.02));
        QVERIFY(physics->isStuck(body));
    }

    void knowsWhatIsInsideSomething_data() {
        QTest::addColumn<Vec3>("position_m");
        QTest::addColumn<bool>("stuck");
        QTest::newRow("in free air") << Vec3(0.0, 0.0, 3.0) << false;
        QTest::newRow("deep under the ground") << Vec3(0.0, 0.0, -9.0) << true;
        QTest::newRow("in a trunk") << Vec3(5.0, 0.1, 1.0) << true;
        QTest::newRow("in a round crown") << Vec3(5.0, 1.0, 4.5) << true;
        QTest::newRow("beside a trunk, under the crown") << Vec3(5.0, 0.5, 1.0) << false;
        QTest::newRow("in a cone") << Vec3(-5.0, 0.2, 3.0) << true;
        QTest::newRow("beside the cone's tip") << Vec3(-5.0, 0.4, 4.5) << false;
        QTest::newRow("in a house") << Vec3(0.0, 6.0, 1.5) << true;
        QTest::newRow("beyond the edge, below the ground's level") << Vec3(40.0, 0.0, -3.0) << false;
    }
    void knowsWhatIsInsideSomething() {
        QFETCH(Vec3, position_m);
        QFETCH(bool, stuck);
        const World world = furnishedWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(), Pose{position_m, 0.0, 0.0, 0.0});
        QCOMPARE(physics->isStuck(body), stuck);
    }

    void aBodyInsideAnotherIsStuck() {
        const World world = furnishedWorld();
        const auto physics = makePhysics(world);
        const BodyId first = physics->add(ball(), at(0.0, 0.0, 3.0));
        QCOMPARE(physics->distanceToBodies_m({0.0, 0.0, 3.0}, first), std::numeric_limits<double>::infinity());
        const BodyId second = physics->add(ball(), at(0.05, 0.0, 3.0));
        QVERIFY(physics->isStuck(second));
        QCOMPARE(physics->distanceToBodies_m({0.05, 0.0, 3.0}, second), 0.05);
        physics->place(second, at(0.5, 0.0, 3.0));
        QVERIFY(!physics->isStuck(second));
        physics->remove(first);
        physics->place(second, at(0.0, 0.0, 3.0));
        QVERIFY(!physics->isStuck(second));
    }

    void contactsSayWhatWasHitAndHowFast_data() {
        QTest::addColumn<Vec3>("from_m");
        QTest::addColumn<int>("surface");
        QTest::newRow("ground") << Vec3(0.0, 0.0, 0.25) << static_cast<int>(Surface::Ground);
        QTest::newRow("tree top") << Vec3(5.0, 0.0, 5.75) << static_cast<int>(Surface::Plant);
        QTest::newRow("roof") << Vec3(0.0, 6.0, 2.25) << static_cast<int>(Surface::Building);
    }
    void contactsSayWhatWasHitAndHowFast() {
        QFETCH(Vec3, from_m);
        QFETCH(int, surface);
        const World world = furnishedWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(), Pose{from_m, 0.0, 0.0, 0.0});
        for (int i = 0; i < 100 && physics->contacts(body).empty(); ++i)
            physics->step(physics_dt);
        QVERIFY(!physics->contacts(body).empty());
        const Contact contact = physics->contacts(body).front();
        QCOMPARE(static_cast<int>(contact.surface), surface);
        QVERIFY(std::abs(contact.closing_speed_m_s - std::sqrt(2.0 * gravity_m_s2 * 0.2)) < 0.06);
        QVERIFY(contact.impulse_n_s > 0.5);
        QVERIFY(contact.point_in_body_m.z() < -0.04);
    }

    void whatIsPressedThroughTheGroundComesOut() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        for (const double z_m : {-0.02, -0.2}) {
            const BodyId pressed = physics->add(ball(), at(0.0, 0.0, z_m));
            for (int i = 0; i < 500; ++i)
                physics->step(physics_dt);
            const BodyState free = physics->state(pressed);
            QVERIFY2(std::abs(free.position_m.z() - 0.05) < 0.005, qPrintable(QString::number(free.position_m.z())));
            physics->remove(pressed);
        }
    }

    void whatIsCarriedThroughTheGroundStaysWhereItIsPut() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId carried = physics->add(ball(), at(0.0, 0.0, 1.0));
        for (int i = 0; i < 50; ++i) {
            physics->place(carried, at(0.1 * i, 0.0, -0.5));
            physics->step(physics_dt);
            QVERIFY(physics->state(carried).position_m.z() < -0.49);
        }
    }

    void bothBodiesFeelTheirMeeting() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId low = physics->add(ball(), at(0.0, 0.0, 0.051));
        const BodyId high = physics->add(ball(), at(0.0, 0.0, 0.4));
        for (int i = 0; i < 200 && physics->contacts(high).empty(); ++i)
            physics->step(physics_dt);
        QCOMPARE(physics->contacts(high).front().surface, Surface::Body);
        const auto felt = physics->contacts(low);
        QVERIFY(std::any_of(felt.begin(), felt.end(), [](const Contact& c) { return c.surface == Surface::Body; }));
    }

    void seesOtherBodiesButNotItself() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId eye = physics->add(ball(), at(0.0, 0.0, 3.0));
        QCOMPARE(physics->castAtBodies({0.0, 0.0, 3.0}, Vec3::UnitX(), 5.0, 5.0, eye), 5.0);
        const BodyId other = physics->add(ball(), at(2.0, 0.0, 3.0));
        QVERIFY(std::abs(physics->castAtBodies({0.0, 0.0, 3.0}, Vec3::UnitX(), 5.0, 5.0, eye) - 1.95) < 0.001);
        QCOMPARE(physics->castAtBodies({0.0, 0.0, 3.0}, Vec3::UnitY(), 5.0, 5.0, eye), 5.0);
        QCOMPARE(physics->castAtBodies({0.0, 0.0, 3.0}, -Vec3::UnitZ(), 5.0, 5.0, eye),
                 5.0); // the ground is not a body
        physics->remove(other);
        QCOMPARE(physics->castAtBodies({0.0, 0.0, 3.0}, Vec3::UnitX(), 5.0, 5.0, eye), 5.0);
    }

    void sleepsOnlyWhereAllowedAndWakesWhenHit() {
        const World world = slopeWorld(radians(20.0));
        const auto physics = makePhysics(world);
        const BodyDescription box{1.0, Vec3::Constant(0.01), 0.9, {{BoxShape{{0.2, 0.2, 0.2}}, Pose{}}}};
        const BodyId body = physics->add(box, at(0.0, 0.0, 0.15));
        run(*physics, Seconds{2.0});
        physics->letSleep(body, true);
        run(*physics, Seconds{3.0});
        const Vec3 asleep_m = physics->state(body).position_m;
        run(*physics, Seconds{60.0});
        QCOMPARE(physics->state(body).position_m, asleep_m);
        physics->add(ball(), Pose{asleep_m + Vec3(0.0, 0.0, 2.0), 0.0, 0.0, 0.0});
        run(*physics, Seconds{3.0});
        QVERIFY(physics->state(body).position_m != asleep_m);
    }

    void whatLiesWakesWhenItsPropGoesAndOnlyThen() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const auto crateAt = [&](double x_m, double z_m) {
            const BodyDescription crate{1.0, Vec3::Constant(0.01), 0.9, {{BoxShape{{0.2, 0.2, 0.2}}, Pose{}}}};
            const BodyId body = physics->add(crate, at(x_m, 0.0, z_m));
            physics->letSleep(body, true);
            return body;
        };
        const BodyId prop = crateAt(0.0, 0.1);
        const BodyId top = crateAt(0.0, 0.3);
        const BodyId far = crateAt(5.0, 0.1);
        run(*physics, Seconds{20.0}); // A pile takes some ten seconds to settle.
        for (const BodyId body : {prop, top, far})
            QVERIFY(physics->isAsleep(body));
        physics->remove(prop);
        QVERIFY(!physics->isAsleep(top));
        QVERIFY(physics->isAsleep(far));
        run(*physics, Seconds{1.0});
        QVERIFY(std::abs(physics->state(top).position_m.z() - 0.1) < 0.005);
        run(*physics, Seconds{3.0});
        physics->place(top, at(5.0, 0.0, 1.0)); // falls onto the other one
        run(*physics, Seconds{1.0});
        QVERIFY(std::abs(physics->state(top).position_m.z() - 0.3) < 0.005);
    }

    void cratesOnHillsFallAsleep() {
        const World world =
            groundOf([](const Vec2& at) { return 2.0 * std::sin(at.x() / 6.0) * std::cos(at.y() / 6.0); });
        const auto physics = makePhysics(world);
        const BodyDescription crate{1.0, Vec3::Constant(0.0067), 0.9, {{BoxShape{{0.2, 0.2, 0.2}}, Pose{}}}};
        std::vector<BodyId> crates;
        for (int i = 0; i < 100; ++i) {
            const Vec2 at_m(2.0 * (i % 10) - 9.0, 2.0 * (i / 10) - 9.0);
            crates.push_back(physics->add(crate, at(at_m.x(), at_m.y(), world.terrain.height_m(at_m) + 0.3)));
            physics->letSleep(crates.back(), true);
        }
        run(*physics, Seconds{30.0});
        const auto asleep = std::ranges::count_if(crates, [&](BodyId id) { return physics->isAsleep(id); });
        QCOMPARE(asleep, 100);
    }

    // A body that never rests makes Bullet do each step. It is too far away to matter otherwise.
    void aRobotFliesAloneAsItDoesWhereBulletDoesEachStep() {
        Flight alone(furnishedWorld(), inTheAir({0.0, 0.0, 6.0}));
        Flight other(furnishedWorld(), inTheAir({0.0, 0.0, 6.0}));
        BodyDescription belt = ball();
        belt.still = true;
        other.physics->add(belt, at(25.0, 25.0, 1.0));
        for (const auto& [forward_m_s, left_m_s, climb_m_s, yaw_rad_s] :
             {std::array{1.5, 0.0, 0.3, 0.4}, std::array{-1.0, 0.5, -0.5, -0.8}, std::array{0.0, 2.0, 0.6, 0.0},
              std::array{0.0, 0.0, -1.0, 0.2}}) {
            alone.drive(forward_m_s, left_m_s, climb_m_s, yaw_rad_s);
            other.drive(forward_m_s, left_m_s, climb_m_s, yaw_rad_s);
            for (int i = 0; i < 250; ++i) {
                alone.run(physics_dt);
                other.run(physics_dt);
                QCOMPARE(bitsOf(alone.robot.state()), bitsOf(other.robot.state()));
            }
        }
        alone.run(Seconds{20.0}); // down to the ground
        other.run(Seconds{20.0});
        QCOMPARE(alone.atRest(), other.atRest());
        QVERIFY((alone.pose().position_m - other.pose().position_m).norm() < 1e-6);
    }

    void whatMeetsInTheAirMeetsAsInBullet_data() {
        QTest::addColumn<Vec3>("from_m");
        QTest::addColumn<Vec3>("push_n_s");
        QTest::newRow("head on") << Vec3(4.0, 0.0, 30.0) << Vec3(-8.0, 0.0, 0.0);
        QTest::newRow("from above") << Vec3(0.0, 0.0, 34.0) << Vec3(0.0, 0.0, -6.0);
        QTest::newRow("one overtakes the other") << Vec3(-5.0, 0.0, 30.0) << Vec3(9.0, 0.0, 0.0);
        QTest::newRow("they pass by") << Vec3(4.0, 0.3, 30.0) << Vec3(-8.0, 0.0, 0.0);
    }
    void whatMeetsInTheAirMeetsAsInBullet() {
        QFETCH(Vec3, from_m);
        QFETCH(Vec3, push_n_s);
        const auto fall = [&](bool belt_beside) {
            const World world = flatWorld();
            const auto physics = makePhysics(world);
            const BodyId one = physics->add(ball(), at(0.0, 0.0, 30.0));
            const BodyId two = physics->add(ball(), Pose{from_m, 0.0, 0.0, 0.0});
            BodyDescription belt = ball();
            belt.still = true;
            if (belt_beside)
                physics->add(belt, at(-25.0, 25.0, 1.0));
            physics->apply(one, Vec3(1.0, 0.0, 0.0) / physics_dt.count(), Vec3::Zero());
            physics->apply(two, push_n_s / physics_dt.count(), Vec3::Zero());
            std::vector<double> met;
            for (int i = 0; i < 500; ++i) {
                physics->step(physics_dt);
                if (!physics->contacts(one).empty())
                    met.push_back(i);
            }
            const auto state = bitsOf(physics->state(two));
            met.insert(met.end(), state.begin(), state.end());
            return met;
        };
        QCOMPARE(fall(false), fall(true));
    }

    // The post falls down beside a body that has looked around before, and falls asleep there.
    void whatComesToRestBesideAHoveringBodyIsMet() {
        const auto drift = [](bool belt_beside) {
            const World world = flatWorld();
            const auto physics = makePhysics(world);
            const BodyId hovering = physics->add(ball(), at(0.0, 0.0, 1.1));
            const BodyDescription post{1.0, {0.17, 0.17, 0.015}, 0.9, {{BoxShape{{0.3, 0.3, 1.4}}, Pose{}}}};
            const BodyId falling = physics->add(post, at(0.38, 0.0, 3.0));
            BodyDescription belt = ball();
            belt.still = true;
            if (belt_beside)
                physics->add(belt, at(-25.0, 25.0, 1.0));
            physics->letSleep(falling, true);
            const auto hover = [&](double push_n) {
                physics->apply(hovering, {push_n, 0.0, gravity_m_s2}, Vec3::Zero());
                physics->step(physics_dt);
            };
            for (int i = 0; i < 2500; ++i)
                hover(0.0);
            const bool asleep = physics->isAsleep(falling);
            int until_met = 0;
            for (; physics->contacts(hovering).empty() && until_met < 500; ++until_met)
                hover(until_met < 25 ? 2.0 : 0.0);
            return std::pair(asleep, until_met);
        };
        const auto [asleep, until_met] = drift(false);
        QVERIFY(asleep);
        QVERIFY(until_met < 500);
        QCOMPARE(until_met, drift(true).second);
    }

    void groundEndsAtTheEdgeWithoutHarm() {
        const World world = flatWorld();
        const auto physics = makePhysics(world);
        const BodyId body = physics->add(ball(), at(500.0, 0.0, 1.0));
        run(*physics, Seconds{120.0});
        QVERIFY(physics->state(body).position_m.z() < -10000.0);
        QCOMPARE(physics->state(body).position_m.x(), 500.0);
    }

    void repeatsItselfBitByBit() {
        const auto fall = [] {
            const World world = furnishedWorld();
            const auto physics = makePhysics(world);
            std::vector<BodyId> bodies;
            for (int i = 0; i < 20; ++i)
                bodies.push_back(physics->add(ball(), at(4.0 + 0.1 * i, 0.03 * i, 7.0 + 0.3 * i)));
            run(*physics, Seconds{5.0});
            std::vector<double> places_m;
            for (const BodyId body : bodies)
                for (const double part_m : physics->state(body).position_m)
                    places_m.push_back(part_m);
            return places_m;
        };
        QCOMPARE(fall(), fall());
    }
};

USAR_TEST(tst_Physics)

} // namespace tst_physics

#include "tst_physics.moc"
