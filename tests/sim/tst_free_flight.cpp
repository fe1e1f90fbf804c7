#include <random>

#include <QTest>

#include "core/sim/physics/bullet_ground.h"
#include "core/sim/physics/bullet_rigid_body.h"
#include "core/sim/physics/free_flight.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_free_flight {

using namespace usar;
using namespace usar::sim;

namespace {

/// How far a body flies at least before it looks around again.
constexpr double short_travel_m = 0.12;

Pose at(const Vec3& position_m) {
    return {position_m, 0.0, 0.0, 0.0};
}

/// Flat ground with a tree at x = 5 m and a house of 2 m at y = 6 m.
World gardenWorld() {
    World world = flatWorld();
    world.plants.push_back({{5.0, 0.0, 0.0}, 0.3, 4.0, CrownShape::Sphere, 1.5, 0.0});
    world.boxes.push_back({at({0.0, 6.0, 1.0}), {2.0, 2.0, 2.0}});
    return world;
}

struct AnyContact : btCollisionWorld::ContactResultCallback {
    bool found = false;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
        found |= point.getDistance() < 0.0; // Bullet also reports what comes near.
        return 0.0;
    }
};

QByteArray describe(const Vec3& position_m) {
    return QStringLiteral("at %1 %2 %3").arg(position_m.x()).arg(position_m.y()).arg(position_m.z()).toUtf8();
}

/// Bullet's world around the ground of one of ours, as the physics has it.
struct Surroundings {
    explicit Surroundings(World world_) : world(std::move(world_)) {
        bullet.setGravity({0.0, 0.0, -gravity_m_s2});
        for (const auto& object : ground.objects())
            bullet.addCollisionObject(object.get(), ground_group, body_group);
    }
    ~Surroundings() {
        for (const auto& object : ground.objects())
            bullet.removeCollisionObject(object.get());
    }

    /// True if Bullet finds that a sphere touches what stands here, without the ground.
    bool touchSphere(const Vec3& center_m, double radius_m) {
        btSphereShape shape(radius_m);
        btCollisionObject sphere;
        sphere.setCollisionShape(&shape);
        sphere.setWorldTransform(btTransform(btQuaternion::getIdentity(), toBullet(center_m)));
        AnyContact contact;
        for (const auto& object : ground.objects())
            if (object->getUserIndex() != static_cast<int>(Surface::Ground))
                bullet.contactPairTest(&sphere, object.get(), contact);
        return contact.found;
    }

    World world;
    BulletGround ground{world};
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld bullet{&dispatcher, &broadphase, &solver, &configuration};
    FreeFlight flight{bullet, broadphase, world.terrain};
};

} // namespace

class tst_FreeFlight : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatHasNothingNearFliesFreely_data() {
        QTest::addColumn<Vec3>("position_m");
        QTest::addColumn<bool>("free");
        QTest::newRow("high in the air") << Vec3(0.0, 0.0, 20.0) << true;
        QTest::newRow("2 m over the ground") << Vec3(-5.0, -5.0, 2.0) << true;
        QTest::newRow("half a meter over the ground") << Vec3(-5.0, -5.0, 0.5) << false;
        QTest::newRow("under the ground") << Vec3(-5.0, -5.0, -3.0) << false;
        QTest::newRow("beside a trunk") << Vec3(5.8, 0.0, 2.0) << false;
        QTest::newRow("over a crown") << Vec3(5.0, 0.0, 7.0) << true;
        QTest::newRow("near a crown") << Vec3(5.0, 0.0, 6.0) << false;
        QTest::newRow("over a roof") << Vec3(0.0, 6.0, 3.5) << true;
        QTest::newRow("near a roof") << Vec3(0.0, 6.0, 2.4) << false;
        QTest::newRow("beyond the world's edge") << Vec3(80.0, 0.0, 20.0) << true;
    }
    void onlyWhatHasNothingNearFliesFreely() {
        QFETCH(Vec3, position_m);
        QFETCH(bool, free);
        Surroundings around(gardenWorld());
        BulletRigidBody body(around.bullet, airRobotBody(), at(position_m), BodyId{1});
        std::array<BulletBody*, 1> awake{&body};
        QCOMPARE(around.flight.step(awake, physics_dt), free);
        QCOMPARE(fromBullet(body.position()) != position_m, free); // It begins to fall.
    }

    /// Against Bullet's own search for contacts, with a sphere around the body in all its directions.
    void nothingThatStandsIsOverlooked() {
        World world = gardenWorld();
        world.plants.push_back({{-5.0, 0.0, 0.0}, 0.2, 3.0, CrownShape::Cone, 1.2, 2.5});
        world.boxes.push_back({{{0.0, -6.0, 1.5}, 0.3, -0.4, 0.7}, {1.0, 3.0, 0.5}});
        Surroundings around(std::move(world));
        const double radius_m = BulletShape(airRobotBody()).radius_m();
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> across_m(-8.0, 8.0), up_m(radius_m + 0.5, 8.0);
        int free = 0, near = 0;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 position_m(across_m(random), across_m(random), up_m(random));
            const bool touches = around.touchSphere(position_m, radius_m + short_travel_m - 0.001);
            const bool clear = !around.touchSphere(position_m, radius_m + short_travel_m + 0.1);
            BulletRigidBody body(around.bullet, airRobotBody(), at(position_m), BodyId{1});
            std::array<BulletBody*, 1> awake{&body};
            const bool flies = around.flight.step(awake, physics_dt);
            QVERIFY2(!(touches && flies), describe(position_m));
            QVERIFY2(!(clear && !flies), describe(position_m)); // Cones have twelve sides in Bullet, and none here.
            ++(flies ? free : near);
        }
        QVERIFY(free > 300);
        QVERIFY(near > 100);
    }

    void whatMayRestDoesNot() {
        Surroundings around(gardenWorld());
        BulletRigidBody body(around.bullet, airRobotBody(), at({0.0, 0.0, 20.0}), BodyId{1});
        std::array<BulletBody*, 1> awake{&body};
        body.letSleep(true);
        QVERIFY(!around.flight.step(awake, physics_dt));
        body.letSleep(false);
        QVERIFY(around.flight.step(awake, physics_dt));
    }

    void twoFlyFreelyOnlyWhereTheyAreApart_data() {
        QTest::addColumn<double>("apart_m");
        QTest::addColumn<bool>("free");
        QTest::newRow("apart") << 3.5 << true;
        QTest::newRow("close") << 1.5 << false;
    }
    void twoFlyFreelyOnlyWhereTheyAreApart() {
        QFETCH(double, apart_m);
        QFETCH(bool, free);
        Surroundings around(gardenWorld());
        BulletRigidBody one(around.bullet, airRobotBody(), at({0.0, 0.0, 20.0}), BodyId{1});
        BulletRigidBody two(around.bullet, airRobotBody(), at({apart_m, 0.0, 20.0}), BodyId{2});
        std::array<BulletBody*, 2> awake{&one, &two};
        QCOMPARE(around.flight.step(awake, physics_dt), free);
    }

    void itIsFoundOutInTimeThatTheGroundComesNear() {
        Surroundings around(gardenWorld());
        BulletRigidBody body(around.bullet, airRobotBody(), at({-5.0, -5.0, 10.0}), BodyId{1});
        std::array<BulletBody*, 1> awake{&body};
        while (around.flight.step(awake, physics_dt)) {
        }
        QVERIFY(body.position().z() < 2.5); // It fell freely for nearly all of the way,
        QVERIFY(body.position().z() > 0.8); // but not into the ground.
    }

    void aBodyIsWithinItsRadius() {
        const BodyDescription lopsided{
            1.0,
            Vec3::Constant(0.1),
            0.9,
            {{SphereShape{0.1}, at({-0.9, 0.0, 0.0})}, {SphereShape{0.1}, at({0.0, 0.9, 0.9})}}};
        QVERIFY(BulletShape(lopsided).radius_m() >= std::hypot(0.9, 0.9) + 0.1);
        QVERIFY(BulletShape(lopsided).radius_m() < 1.8);
    }
};

USAR_TEST(tst_FreeFlight)

} // namespace tst_free_flight

#include "tst_free_flight.moc"
