// What a bundle of rays hears is bit for bit the least of what each of its rays does alone: in all worlds that come
// with the program, with bodies about, from anywhere.
#include <algorithm>

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/rays/ray_bundle.h"
#include "core/sim/sensors/rays.h"
#include "core/sim/world/world_generator.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"

namespace tst_ray_bundle {

using namespace usar;
using namespace usar::sim;

namespace {

Vec3 randomDirection(Random& random) {
    return Vec3{gaussian(random, 1.0), gaussian(random, 1.0), gaussian(random, 1.0)}.normalized();
}

/// A cone of a random width, sometimes so wide that rays go back, along an axis of the map each now and then.
std::vector<Vec3> randomCone(Random& random) {
    Vec3 axis = randomDirection(random);
    const double kind = uniform(random, 0.0, 1.0);
    if (kind < 0.2)
        axis.z() = 0.0;
    else if (kind < 0.3)
        axis = -Vec3::UnitZ();
    else if (kind < 0.4)
        axis = Vec3::UnitX();
    std::vector<Vec3> directions{axis.normalized()};
    const double width = uniform(random, 0.0, 1.0) < 0.8 ? 0.13 : 3.0;
    while (directions.size() < 9)
        directions.push_back((directions.front() + width * randomDirection(random)).normalized());
    return directions;
}

/// Somewhere over, in or beside the world, mostly near its ground; now and then just beside a body.
Vec3 randomEye(Random& random, const World& world, const Physics& physics, const std::vector<BodyId>& bodies) {
    if (uniform(random, 0.0, 1.0) < 0.3) {
        const auto which = static_cast<std::size_t>(uniform(random, 0.0, 1.0) * static_cast<double>(bodies.size()));
        return physics.state(bodies[which]).position_m + uniform(random, 0.3, 4.0) * randomDirection(random);
    }
    const Rectangle extent = extentOf(world);
    const Vec2 at_m{uniform(random, extent.min_m.x() - 3.0, extent.max_m.x() + 3.0),
                    uniform(random, extent.min_m.y() - 3.0, extent.max_m.y() + 3.0)};
    return {at_m.x(), at_m.y(), world.terrain.height_m(at_m) + uniform(random, -0.5, 7.0)};
}

/// Balls, boxes and one that looks, somewhere on the world.
std::vector<BodyId> addBodies(Random& random, const World& world, Physics& physics) {
    const Rectangle extent = extentOf(world);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 60; ++i) {
        BodyDescription body;
        if (i % 2 == 0)
            body.parts = {{SphereShape{uniform(random, 0.05, 0.6)}, Pose{}}};
        else
            body.parts = {{BoxShape{{0.4, uniform(random, 0.1, 1.0), 0.3}}, Pose{.position_m = {0.1, 0.0, 0.2}}}};
        const Vec2 at_m{uniform(random, extent.min_m.x(), extent.max_m.x()),
                        uniform(random, extent.min_m.y(), extent.max_m.y())};
        const Pose place{.position_m = {at_m.x(), at_m.y(), world.terrain.height_m(at_m) + uniform(random, 0.3, 5.0)},
                         .roll_rad = uniform(random, -3.0, 3.0),
                         .yaw_rad = uniform(random, -3.0, 3.0)};
        bodies.push_back(physics.add(body, place));
    }
    return bodies;
}

} // namespace

class tst_RayBundle : public QObject {
    Q_OBJECT

private slots:
    void hearsTheLeastOfItsRaysInEveryWorld_data() {
        QTest::addColumn<World>("world");
        for (const std::string& name : generatedWorldNames()) {
            auto world = makeWorld(name, 1, USAR_SOURCE_DIR "/resources/worlds");
            QVERIFY(world.has_value());
            QTest::newRow(name.c_str()) << *std::move(world);
        }
        QTest::newRow("a thicket on waves") << doubles::woodedWorld(3, 200);
        QTest::newRow("the roughest ground") << doubles::roughWorld(3);
    }
    void hearsTheLeastOfItsRaysInEveryWorld() {
        QFETCH(const World, world);
        Random random = seeded(41, 7);
        const RayCaster still(world);
        const auto physics = makePhysics(world);
        const std::vector<BodyId> bodies = addBodies(random, world, *physics);
        const WorldRays rays(still, *physics, bodies.front());
        int misses = 0;
        int hits = 0;
        int bodies_heard = 0;
        for (int i = 0; i < 6000; ++i) {
            const Vec3 origin_m = randomEye(random, world, *physics, bodies);
            const std::vector<Vec3> directions = randomCone(random);
            const double maximum_m = i % 20 == 0 ? 60.0 : uniform(random, 0.2, 6.0);
            double alone_m = maximum_m;
            double still_m = maximum_m;
            double echo_m = maximum_m;
            std::vector<double> each_m;
            for (const Vec3& direction : directions) {
                each_m.push_back(rays.cast(origin_m, direction, maximum_m));
                alone_m = std::min(alone_m, each_m.back());
                const RayHit hit = still.look(origin_m, direction, echo_m);
                const double body_m =
                    physics->castAtBodies(origin_m, direction, maximum_m, hit.distance_m, bodies.front());
                if (body_m < hit.distance_m || still.sendsEcho(origin_m, direction, hit))
                    echo_m = std::min(body_m, hit.distance_m);
                still_m = std::min(still_m, still.cast(origin_m, direction, maximum_m));
            }
            QVERIFY(still.castNearest({origin_m, directions}, maximum_m) == still_m);
            QVERIFY(rays.castNearest(origin_m, directions, maximum_m) == alone_m);
            QVERIFY(rays.nearestEcho(origin_m, directions, maximum_m) == echo_m);
            std::vector<double> together_m{1.0};
            rays.castEach(origin_m, directions, maximum_m, together_m);
            QVERIFY(together_m == each_m);
            ++(alone_m == maximum_m ? misses : hits);
            bodies_heard += alone_m < still_m ? 1 : 0;
        }
        const QByteArray figures =
            QString("%1 hits, %2 misses, %3 bodies").arg(hits).arg(misses).arg(bodies_heard).toUtf8();
        QVERIFY2(misses > 300 && hits > 300 && bodies_heard > 50, figures);
    }

    void theLengthOfALookDoesNotMoveTheGround() {
        const World world = doubles::roughWorld(5);
        const RayCaster caster(world);
        Random random = seeded(42, 7);
        for (int i = 0; i < 5000; ++i) {
            const Vec3 origin_m{uniform(random, -9.0, 9.0), uniform(random, -9.0, 9.0), uniform(random, 0.0, 5.0)};
            const Vec3 direction = randomDirection(random);
            const double far_m = caster.cast(origin_m, direction, 100.0);
            for (const double more : {1e-12, 1e-6, 0.01, 1.0})
                if (far_m < 100.0)
                    QVERIFY(caster.cast(origin_m, direction, far_m + more) == far_m);
            QVERIFY(caster.cast(origin_m, direction, far_m / 2.0) == far_m / 2.0);
        }
    }

    void deniesNothingThatARayMeets() {
        Random random = seeded(43, 7);
        int denied = 0;
        for (int i = 0; i < 20000; ++i) {
            const std::vector<Vec3> directions = randomCone(random);
            const Vec3 origin_m = 5.0 * randomDirection(random);
            const RayBundle bundle(origin_m, directions);
            const double length_m = uniform(random, 0.5, 8.0);
            const Vec2 column_m{uniform(random, -8.0, 8.0), uniform(random, -8.0, 8.0)};
            const double radius_m = uniform(random, 0.0, 2.0);
            const bool may_meet = bundle.mayMeetColumn(column_m, radius_m, length_m);
            denied += may_meet ? 0 : 1;
            for (const Vec3& direction : directions)
                for (double along_m = 0.0; along_m <= length_m; along_m += length_m / 16.0) {
                    const Vec3 point_m = origin_m + along_m * direction;
                    QVERIFY(bundle.box(length_m).contains(point_m));
                    QVERIFY(may_meet || (point_m.head<2>() - column_m).norm() > radius_m);
                }
        }
        QVERIFY(denied > 5000);
    }
};

USAR_TEST(tst_RayBundle)

} // namespace tst_ray_bundle

#include "tst_ray_bundle.moc"
