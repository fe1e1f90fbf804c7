// Rays against single solids: the closed forms against a walk along the ray that only asks whether a point is inside.
#include <algorithm>
#include <cmath>
#include <functional>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/base/random.h"
#include "core/sim/camera/seen_solids.h"
#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_shapes.h"
#include "core/sim/world/world.h"
#include "tests/suite/suite.h"

namespace tst_ray_shapes {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr double far_m = 20.0;
constexpr double pace_m = 0.02;

using Inside = std::function<bool(const Vec3&)>;

Vec3 randomIn(Random& random, double half_m) {
    return {uniform(random, -half_m, half_m), uniform(random, -half_m, half_m), uniform(random, -half_m, half_m)};
}

Vec3 randomUnit(Random& random) {
    return Vec3{gaussian(random, 1.0), gaussian(random, 1.0), gaussian(random, 1.0)}.normalized();
}

Pose randomPose(Random& random) {
    return {randomIn(random, 3.0), uniform(random, -pi, pi), uniform(random, -1.5, 1.5), uniform(random, -pi, pi)};
}

/// The first distance at which the ray is inside, found step by step and then halved; no_hit_m if no step is inside.
double entersAt(const Inside& inside, const Ray& ray) {
    const auto at = [&](double t) { return inside(ray.origin_m + t * ray.direction); };
    for (double t = 0.0; t < far_m; t += pace_m) {
        if (!at(t))
            continue;
        double out = std::max(0.0, t - pace_m);
        double in = t;
        for (int i = 0; i < 60 && t > 0.0; ++i)
            (at((in + out) / 2.0) ? in : out) = (in + out) / 2.0;
        return in;
    }
    return no_hit_m;
}

/// Whether a point of the solid's own frame is inside it, the solid being larger by `more_m` on all sides.
bool isInside(const Shape& shape, const Vec3& point_m, double more_m = 0.0) {
    if (const auto* const box = std::get_if<BoxShape>(&shape))
        return (point_m.cwiseAbs() - box->size_m / 2.0).maxCoeff() <= more_m;
    if (const auto* const ball = std::get_if<SphereShape>(&shape))
        return point_m.norm() <= ball->radius_m + more_m;
    if (const auto* const rod = std::get_if<CylinderShape>(&shape))
        return point_m.head<2>().norm() <= rod->radius_m + more_m &&
               std::abs(point_m.z()) <= rod->height_m / 2.0 + more_m;
    const auto& pill = std::get<CapsuleShape>(shape);
    const double along_m = std::clamp(point_m.z(), -pill.height_m / 2.0, pill.height_m / 2.0);
    return (point_m - Vec3(0.0, 0.0, along_m)).norm() <= pill.radius_m + more_m;
}

Inside solidAt(const Shape& shape, const Pose& solid_in_map, double more_m = 0.0) {
    const Eigen::Isometry3d map_in_solid = solid_in_map.isometry().inverse();
    return [=](const Vec3& point_m) { return isInside(shape, map_in_solid * point_m, more_m); };
}

void addShapes(bool with_capsule = true) {
    QTest::addColumn<Shape>("shape");
    QTest::newRow("ball") << Shape(SphereShape{0.8});
    QTest::newRow("box") << Shape(BoxShape{{1.2, 2.0, 0.7}});
    QTest::newRow("plank") << Shape(BoxShape{{3.0, 0.5, 0.3}});
    QTest::newRow("drum") << Shape(CylinderShape{1.0, 0.6});
    QTest::newRow("pipe") << Shape(CylinderShape{0.3, 3.0});
    if (with_capsule)
        QTest::newRow("pill") << Shape(CapsuleShape{0.5, 1.5});
}

double hitOf(const QString& solid, const Ray& ray) {
    if (solid == "cylinder")
        return hitCylinder(ray, {0.0, 0.0, 0.0}, 1.0, 3.0);
    if (solid == "sphere")
        return hitSphere(ray, {0.0, 0.0, 0.0}, 1.0);
    if (solid == "cone")
        return hitCone(ray, {0.0, 0.0, 0.0}, 1.0, 3.0);
    return hitBox(ray, {0.0, 0.0, 0.0}, Eigen::Matrix3d::Identity(), {1.0, 1.0, 1.0});
}

void solidRow(const char* row, const char* solid, const Vec3& from_m, const Vec3& direction, double distance_m) {
    QTest::newRow(row) << QString(solid) << from_m << direction << distance_m;
}

/// What one picture of the camera at the origin, looking along x, tells of a solid.
std::optional<SolidHit> seenAlong(const SeenSolid& solid, double x_px, double y_px, Ray& ray_out) {
    CameraScene scene;
    scene.solids = {solid};
    SeenFrom camera;
    const Eye eye(camera);
    ray_out = eye.through(x_px, y_px);
    const SeenSolids solids(scene, eye);
    return solids.look(ray_out, static_cast<int>(x_px) / SeenSolids::tile_px,
                       static_cast<int>(y_px) / SeenSolids::tile_px, far_m);
}

} // namespace

class tst_RayShapes : public QObject {
    Q_OBJECT

private slots:
    void limitsOfEachSolid_data() {
        QTest::addColumn<QString>("solid");
        QTest::addColumn<Vec3>("from_m");
        QTest::addColumn<Vec3>("direction");
        QTest::addColumn<double>("distance_m");
        const Vec3 x = Vec3::UnitX();
        const Vec3 z = Vec3::UnitZ();
        solidRow("cylinder from the side", "cylinder", {-5, 0, 1}, x, 4.0);
        solidRow("cylinder along its axis from above", "cylinder", {0.5, 0, 5}, -z, 2.0);
        solidRow("cylinder along its axis from below", "cylinder", {0.5, 0, -2}, z, 2.0);
        solidRow("cylinder missed along its axis", "cylinder", {1.01, 0, 5}, -z, no_hit_m);
        solidRow("cylinder in the plane of its cap", "cylinder", {-5, 0, 3}, x, 4.0);
        solidRow("over the cylinder", "cylinder", {-5, 0, 3.001}, x, no_hit_m);
        solidRow("past the cylinder", "cylinder", {-5, 1.001, 1}, x, no_hit_m);
        solidRow("cylinder behind", "cylinder", {5, 0, 1}, x, no_hit_m);
        solidRow("inside the cylinder", "cylinder", {0.2, 0.3, 1}, x, 0.0);
        solidRow("sphere ahead", "sphere", {-5, 0, 0}, x, 4.0);
        solidRow("sphere off its middle", "sphere", {-5, 0.6, 0}, x, 4.2);
        solidRow("sphere behind", "sphere", {5, 0, 0}, x, no_hit_m);
        solidRow("past the sphere", "sphere", {-5, 1.001, 0}, x, no_hit_m);
        solidRow("inside the sphere", "sphere", {0.5, 0.5, 0.5}, x, 0.0);
        solidRow("on the sphere, looking away", "sphere", {1, 0, 0}, x, 0.0);
        solidRow("cone at half its height", "cone", {-5, 0, 1.5}, x, 4.5);
        solidRow("cone from straight above", "cone", {0.5, 0, 5}, -z, 3.5);
        solidRow("cone from straight below", "cone", {0.5, 0, -2}, z, 2.0);
        solidRow("over the tip of the cone", "cone", {-5, 0, 3.001}, x, no_hit_m);
        solidRow("under the cone", "cone", {-5, 0, -0.001}, x, no_hit_m);
        solidRow("below the cone, beside it", "cone", {1.1, 0, -2}, z, no_hit_m);
        solidRow("cone behind", "cone", {5, 0, 1.5}, x, no_hit_m);
        solidRow("inside the cone", "cone", {0.1, 0, 0.5}, x, 0.0);
        solidRow("above the tip, where its mirror image would be", "cone", {-5, 0, 4.5}, x, no_hit_m);
        solidRow("box ahead", "box", {-5, 0, 0}, x, 4.0);
        solidRow("along a side of the box", "box", {-5, 1, 0}, x, 4.0);
        solidRow("just beside the box", "box", {-5, 1.001, 0}, x, no_hit_m);
        solidRow("box behind", "box", {5, 0, 0}, x, no_hit_m);
        solidRow("inside the box", "box", {0.9, 0.9, 0.9}, x, 0.0);
        solidRow("the box's edge at 45 degrees", "box", {-2, 0, 1.5}, Vec3(1, 0, -1).normalized(), std::sqrt(2.0));
    }
    void limitsOfEachSolid() {
        QFETCH(const QString, solid);
        QFETCH(const Vec3, from_m);
        QFETCH(const Vec3, direction);
        QFETCH(const double, distance_m);
        const double hit_m = hitOf(solid, {from_m, direction});
        if (std::isinf(distance_m))
            QVERIFY2(std::isinf(hit_m), qPrintable(QString::number(hit_m)));
        else
            QVERIFY2(std::abs(hit_m - distance_m) < 1e-9, qPrintable(QString::number(hit_m)));
    }

    void uprightSolidsBeginWhereAWalkEntersThem_data() {
        QTest::addColumn<QString>("solid");
        for (const char* solid : {"cylinder", "sphere", "cone", "box"})
            QTest::newRow(solid) << QString(solid);
    }
    void uprightSolidsBeginWhereAWalkEntersThem() {
        QFETCH(const QString, solid);
        const auto inside = [&](const Vec3& point_m) {
            const double off_axis_m = point_m.head<2>().norm();
            if (solid == "cylinder")
                return off_axis_m <= 1.0 && point_m.z() >= 0.0 && point_m.z() <= 3.0;
            if (solid == "cone")
                return point_m.z() >= 0.0 && point_m.z() <= 3.0 && off_axis_m <= 1.0 - point_m.z() / 3.0;
            return solid == "sphere" ? point_m.norm() <= 1.0 : point_m.cwiseAbs().maxCoeff() <= 1.0;
        };
        Random random = seeded(11, 1);
        int hits = 0;
        for (int i = 0; i < 400; ++i) {
            const Vec3 from_m = randomIn(random, 6.0);
            const Ray ray{from_m, (randomIn(random, 1.5) - from_m).normalized()};
            const double walked_m = entersAt(inside, ray);
            const double hit_m = hitOf(solid, ray);
            if (std::isinf(walked_m))
                continue; // A corner that is thinner than a pace may be stepped over.
            ++hits;
            QVERIFY2(std::abs(hit_m - walked_m) < 1e-6, qPrintable(QString("ray %1: %2 m").arg(i).arg(hit_m)));
        }
        QVERIFY(hits > 60);
    }

    void turnedBoxesBeginWhereAWalkEntersThem() {
        Random random = seeded(12, 1);
        int hits = 0;
        int misses = 0;
        for (int i = 0; i < 400; ++i) {
            const Pose pose = randomPose(random);
            const Vec3 half_m = randomIn(random, 1.0).cwiseAbs() + Vec3::Constant(0.2);
            const Vec3 from_m = randomIn(random, 8.0);
            const Ray ray{from_m, (pose.position_m + randomIn(random, 2.0) - from_m).normalized()};
            const Eigen::Matrix3d box_in_map = pose.rotation().toRotationMatrix();
            const double hit_m = hitBox(ray, pose.position_m, box_in_map, half_m);
            const Shape box = BoxShape{2.0 * half_m};
            const double walked_m = entersAt(solidAt(box, pose), ray);
            misses += std::isinf(hit_m) ? 1 : 0;
            if (std::isinf(hit_m))
                QVERIFY2(std::isinf(walked_m), qPrintable(QString::number(i)));
            if (std::isinf(walked_m))
                continue;
            ++hits;
            QVERIFY2(std::abs(hit_m - walked_m) < 1e-6, qPrintable(QString::number(i)));
            const Vec3 normal = normalOfBox(ray, hit_m, pose.position_m, box_in_map, half_m);
            QVERIFY(std::abs(normal.norm() - 1.0) < 1e-9);
            QVERIFY2(normal.dot(ray.direction) < 1e-9, qPrintable(QString::number(i)));
        }
        QVERIFY(hits > 60 && misses > 20);
    }

    void normalsPointOutOfTheSolid_data() {
        QTest::addColumn<Vec3>("normal");
        QTest::addColumn<Vec3>("expected");
        const Vec3 base(1.0, 2.0, 0.0);
        QTest::newRow("side of a cylinder") << normalOfCylinder({1.5, 2.0, 1.0}, base, 3.0) << Vec3(1, 0, 0);
        QTest::newRow("other side of a cylinder") << normalOfCylinder({1.0, 1.5, 1.0}, base, 3.0) << Vec3(0, -1, 0);
        QTest::newRow("upper cap") << normalOfCylinder({1.2, 2.1, 3.0}, base, 3.0) << Vec3(0, 0, 1);
        QTest::newRow("lower cap") << normalOfCylinder({1.2, 2.1, 0.0}, base, 3.0) << Vec3(0, 0, -1);
        QTest::newRow("base of a cone") << normalOfCone({0.3, 0.0, 0.0}, 1.0, 3.0) << Vec3(0, 0, -1);
        QTest::newRow("flank of a cone") << normalOfCone({0.5, 0.0, 1.5}, 1.0, 3.0) << Vec3(3, 0, 1).normalized();
        QTest::newRow("tip of a cone") << normalOfCone({0.0, 0.0, 3.0}, 1.0, 3.0) << Vec3(0, 0, 1);
        const Ray ray{{-5.0, 0.0, 0.0}, Vec3::UnitX()};
        const Eigen::Matrix3d level = Eigen::Matrix3d::Identity();
        QTest::newRow("box ahead") << normalOfBox(ray, 4.0, Vec3::Zero(), level, Vec3::Ones()) << Vec3(-1, 0, 0);
        QTest::newRow("inside a box") << normalOfBox(ray, 0.0, {-5, 0, 0}, level, Vec3::Ones()) << Vec3(-1, 0, 0);
    }
    void normalsPointOutOfTheSolid() {
        QFETCH(const Vec3, normal);
        QFETCH(const Vec3, expected);
        QVERIFY((normal - expected).norm() < 1e-9);
    }

    void aPictureShowsEachShapeInAnyPose_data() { addShapes(); }
    void aPictureShowsEachShapeInAnyPose() {
        QFETCH(const Shape, shape);
        Random random = seeded(13, 1);
        int hits = 0;
        for (int i = 0; i < 200; ++i) {
            Pose pose = randomPose(random);
            pose.position_m = {uniform(random, 4.0, 7.0), uniform(random, -0.5, 0.5), uniform(random, -0.5, 0.5)};
            const SeenSolid solid{shape, pose.position_m, pose.rotation().toRotationMatrix(), 3.0,
                                  Color{1.0f, 0.0f, 0.0f}};
            Ray ray;
            const auto seen = seenAlong(solid, uniform(random, 130.0, 190.0), uniform(random, 90.0, 150.0), ray);
            const double walked_m = entersAt(solidAt(shape, pose), ray);
            if (!seen)
                QVERIFY2(std::isinf(walked_m), qPrintable(QString::number(i)));
            if (std::isinf(walked_m))
                continue;
            ++hits;
            QVERIFY2(std::abs(seen->distance_m - walked_m) < 1e-6, qPrintable(QString::number(i)));
            QVERIFY(std::abs(seen->normal_in_map.norm() - 1.0) < 1e-9);
            QVERIFY2(seen->normal_in_map.dot(ray.direction) < 1e-6, qPrintable(QString::number(i)));
            // A little outward is outside, a little inward is inside.
            const Vec3 point_m = ray.origin_m + walked_m * ray.direction;
            QVERIFY(!solidAt(shape, pose)(point_m + 1e-4 * seen->normal_in_map));
        }
        QVERIFY(hits > 20);
    }

    void aCameraInsideASolidDoesNotSeeIt_data() { addShapes(); }
    void aCameraInsideASolidDoesNotSeeIt() {
        QFETCH(const Shape, shape);
        const SeenSolid housing{shape, {0.01, 0.0, 0.0}, Eigen::Matrix3d::Identity(), 3.0, Color{1.0f, 0.0f, 0.0f}};
        Ray ray;
        QVERIFY(!seenAlong(housing, 160.0, 120.0, ray));
    }

    /// Not a capsule: one of a hundred rays meets it up to 1.6 m too late.
    void rangeRaysMeetEachBodyInAnyPose_data() { addShapes(false); }
    void rangeRaysMeetEachBodyInAnyPose() {
        QFETCH(const Shape, shape);
        constexpr double slack_m = 0.02; // The physics engine's own margin.
        World world;
        world.boxes = {{{.position_m = {0.0, 0.0, -50.0}}, {1.0, 1.0, 1.0}}};
        Random random = seeded(14, 1);
        int hits = 0;
        int misses = 0;
        for (int i = 0; i < 100; ++i) {
            const auto physics = makePhysics(world);
            const Pose pose = randomPose(random);
            BodyDescription body;
            body.parts = {{shape, {}}};
            const BodyId self = physics->add(body, {.position_m = {0.0, 0.0, 40.0}});
            physics->add(body, pose);
            const Vec3 from_m = pose.position_m + 6.0 * randomUnit(random);
            const Vec3 direction = (pose.position_m + randomIn(random, 1.2) - from_m).normalized();
            const double hit_m = physics->castAtBodies(from_m, direction, far_m, far_m, self);
            const double fat_m = entersAt(solidAt(shape, pose, slack_m), {from_m, direction});
            const double thin_m = entersAt(solidAt(shape, pose, -slack_m), {from_m, direction});
            QVERIFY2(hit_m >= std::min(fat_m, far_m) - slack_m, qPrintable(QString("%1: too near").arg(i)));
            QVERIFY2(
                hit_m <= std::min(thin_m, far_m) + slack_m,
                qPrintable(QString("%1: %2 m is too far; a walk enters after %3 m").arg(i).arg(hit_m).arg(thin_m)));
            hits += thin_m < far_m ? 1 : 0;
            misses += fat_m > far_m ? 1 : 0;
            QCOMPARE(physics->castAtBodies(from_m, direction, far_m, 1.0, self), 1.0); // nothing is as near as that
        }
        QVERIFY(hits > 10 && misses > 0);
    }
};

USAR_TEST(tst_RayShapes)

} // namespace tst_ray_shapes

#include "tst_ray_shapes.moc"
