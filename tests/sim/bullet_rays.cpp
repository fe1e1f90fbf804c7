#include "tests/sim/bullet_rays.h"

#include <algorithm>
#include <array>
#include <vector>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <btBulletCollisionCommon.h>

namespace usar::doubles {

static_assert(sizeof(btScalar) == 8, "Bullet must be the double precision build");

namespace {

btVector3 toBullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// Möller and Trumbore, both sides.
double hitTriangle(const Vec3& origin_m, const Vec3& direction, const std::array<Vec3, 3>& corners_m) {
    const Vec3 e1 = corners_m[1] - corners_m[0];
    const Vec3 e2 = corners_m[2] - corners_m[0];
    const Vec3 p = direction.cross(e2);
    const double determinant = e1.dot(p);
    if (determinant == 0.0)
        return 1e9;
    const Vec3 s = (origin_m - corners_m[0]) / determinant;
    const double u = s.dot(p);
    const Vec3 q = s.cross(e1);
    const double v = direction.dot(q);
    const double t = e2.dot(q);
    return u >= -1e-12 && v >= -1e-12 && u + v <= 1.0 + 1e-12 && t >= 0.0 ? t : 1e9;
}

} // namespace

struct BulletRays::Scene {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btCollisionWorld bullet{&dispatcher, &broadphase, &configuration};
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btCollisionObject>> objects;

    ~Scene() {
        for (const auto& object : objects)
            bullet.removeCollisionObject(object.get());
    }

    void add(std::unique_ptr<btCollisionShape> shape, const Pose& shape_in_map) {
        const Eigen::Quaterniond q = shape_in_map.rotation();
        auto object = std::make_unique<btCollisionObject>();
        object->setCollisionShape(shape.get());
        object->setWorldTransform(
            btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), toBullet(shape_in_map.position_m)));
        bullet.addCollisionObject(object.get());
        shapes.push_back(std::move(shape));
        objects.push_back(std::move(object));
    }

    void addTerrain(const sim::Terrain& terrain) {
        auto shape = std::make_unique<btHeightfieldTerrainShape>(
            static_cast<int>(terrain.columns()), static_cast<int>(terrain.rows()), terrain.heights_m().data(),
            static_cast<btScalar>(terrain.minimum_m()), static_cast<btScalar>(terrain.maximum_m()), 2, true);
        shape->setLocalScaling({terrain.step_m(), terrain.step_m(), 1.0});
        shape->buildAccelerator(16);
        const Vec2 center_m = terrain.extent().center_m();
        const double middle_m =
            (static_cast<double>(terrain.minimum_m()) + static_cast<double>(terrain.maximum_m())) / 2.0;
        add(std::move(shape), Pose{.position_m = {center_m.x(), center_m.y(), middle_m}});
    }

    void addPlant(const sim::Plant& plant) {
        const Vec3 up_m{0.0, 0.0, plant.trunk_height_m};
        if (plant.trunk_height_m > 0.0) {
            const double r = plant.trunk_radius_m;
            add(std::make_unique<btCylinderShapeZ>(btVector3(r, r, plant.trunk_height_m / 2.0)),
                Pose{.position_m = plant.base_in_map_m + up_m / 2.0});
        }
        if (plant.crown == sim::CrownShape::Sphere)
            add(std::make_unique<btSphereShape>(plant.crown_radius_m), Pose{.position_m = plant.base_in_map_m + up_m});
    }
};

BulletRays::BulletRays(const sim::World& world) : scene_(std::make_unique<Scene>()) {
    if (!world.terrain.empty())
        scene_->addTerrain(world.terrain);
    for (const sim::Plant& plant : world.plants)
        scene_->addPlant(plant);
    for (const sim::Box& box : world.boxes)
        scene_->add(std::make_unique<btBoxShape>(toBullet(box.size_m / 2.0)), box.center_in_map);
}

BulletRays::~BulletRays() = default;

double BulletRays::cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const {
    const btVector3 from = toBullet(origin_m);
    const btVector3 to = toBullet(origin_m + maximum_m * direction);
    btCollisionWorld::ClosestRayResultCallback nearest(from, to);
    scene_->bullet.rayTest(from, to, nearest);
    return nearest.hasHit() ? nearest.m_closestHitFraction * maximum_m : maximum_m;
}

double tryEveryTriangle(const sim::Terrain& terrain, const Vec3& origin_m, const Vec3& direction) {
    double nearest_m = 1e9;
    const auto corner = [&](std::size_t column, std::size_t row) {
        return Vec3{terrain.origin_m().x() + terrain.step_m() * static_cast<double>(column),
                    terrain.origin_m().y() + terrain.step_m() * static_cast<double>(row),
                    static_cast<double>(terrain.post_m(column, row))};
    };
    for (std::size_t row = 0; row + 1 < terrain.rows(); ++row)
        for (std::size_t column = 0; column + 1 < terrain.columns(); ++column) {
            const Vec3 low = corner(column, row);
            const Vec3 high = corner(column + 1, row + 1);
            nearest_m = std::min({nearest_m, hitTriangle(origin_m, direction, {low, corner(column + 1, row), high}),
                                  hitTriangle(origin_m, direction, {low, corner(column, row + 1), high})});
        }
    return nearest_m;
}

} // namespace usar::doubles
