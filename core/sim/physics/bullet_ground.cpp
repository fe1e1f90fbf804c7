#include "core/sim/physics/bullet_ground.h"

#include <cmath>
#include <utility>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

namespace usar::sim {

namespace {

constexpr double hull_margin_m = 0.001;
constexpr int cone_sides = 12;

btTransform at(const Vec3& position_m) {
    return btTransform(btQuaternion::getIdentity(), toBullet(position_m));
}

// The margin of btConeShape makes it 6 cm too thick; a hull can do with less.
void fillCone(btConvexHullShape& hull, double radius_m, double height_m) {
    for (int side = 0; side < cone_sides; ++side) {
        const double angle_rad = 2.0 * pi * side / cone_sides;
        hull.addPoint({radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), 0.0}, false);
    }
    hull.addPoint({0.0, 0.0, height_m}, false);
    hull.recalcLocalAabb();
    hull.setMargin(hull_margin_m);
}

} // namespace

btTransform toBullet(const Pose& pose) {
    const Eigen::Quaterniond q = pose.rotation();
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), toBullet(pose.position_m));
}

BodyState bodyState(const btTransform& body_in_map, const btVector3& velocity_m_s, const btVector3& rate_rad_s) {
    const btQuaternion q = body_in_map.getRotation();
    return {fromBullet(body_in_map.getOrigin()), Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()),
            fromBullet(velocity_m_s), fromBullet(rate_rad_s)};
}

BulletGround::BulletGround(const World& world) {
    if (!world.terrain.empty())
        addTerrain(world.terrain);
    if (!world.plants.empty())
        addPlants(world.plants);
    if (!world.boxes.empty())
        addBoxes(world.boxes);
}

template <class Shape, class... Arguments>
Shape* BulletGround::keep(Arguments&&... arguments) {
    auto shape = std::make_unique<Shape>(std::forward<Arguments>(arguments)...);
    Shape* const plain = shape.get();
    shapes_.push_back(std::move(shape));
    return plain;
}

void BulletGround::addTerrain(const Terrain& terrain) {
    // Bullet centers the field on its bounds, so equal margins keep the center where it is; a flat field needs them.
    const double low_m = terrain.minimum_m() - 1.0;
    const double high_m = terrain.maximum_m() + 1.0;
    const float* const heights_m = terrain.heights_m().data();
    auto* const field =
        keep<btHeightfieldTerrainShape>(static_cast<int>(terrain.columns()), static_cast<int>(terrain.rows()),
                                        heights_m, low_m, high_m, 2, /*flipQuadEdges=*/true);
    field->setLocalScaling({terrain.step_m(), terrain.step_m(), 1.0});
    field->buildAccelerator(16);
    const Vec2 center_m = terrain.extent().center_m();
    addObject(field, at({center_m.x(), center_m.y(), (low_m + high_m) / 2.0}), Surface::Ground);
}

void BulletGround::addPlants(const std::vector<Plant>& plants) {
    auto* const all = keep<btCompoundShape>(true, static_cast<int>(2 * plants.size()));
    for (const Plant& plant : plants) {
        const Vec3 top_m = plant.base_in_map_m + Vec3(0.0, 0.0, plant.trunk_height_m);
        if (plant.trunk_height_m > 0.0 && plant.trunk_radius_m > 0.0) {
            const double half_m = plant.trunk_height_m / 2.0;
            auto* const trunk = keep<btCylinderShapeZ>(btVector3(plant.trunk_radius_m, plant.trunk_radius_m, half_m));
            all->addChildShape(at(plant.base_in_map_m + Vec3(0.0, 0.0, half_m)), trunk);
        }
        if (plant.crown_radius_m <= 0.0)
            continue;
        if (plant.crown == CrownShape::Sphere) {
            all->addChildShape(at(top_m), keep<btSphereShape>(plant.crown_radius_m));
        } else {
            auto* const cone = keep<btConvexHullShape>();
            fillCone(*cone, plant.crown_radius_m, plant.crown_height_m);
            all->addChildShape(at(top_m), cone);
        }
    }
    addObject(all, btTransform::getIdentity(), Surface::Plant);
}

void BulletGround::addBoxes(const std::vector<Box>& boxes) {
    // Each box stands by itself: one compound of all of them would be searched for every part of every robot in each
    // step.
    for (const Box& box : boxes)
        addObject(keep<btBoxShape>(toBullet(Vec3(box.size_m / 2.0))), toBullet(box.center_in_map), Surface::Building);
}

void BulletGround::addObject(btCollisionShape* shape, const btTransform& place, Surface surface) {
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(shape);
    object->setWorldTransform(place);
    object->setFriction(1.0);
    object->setRestitution(1.0); // Bullet multiplies both, so the body decides.
    // Otherwise a sleeping robot's contacts are searched for at every step.
    object->setActivationState(ISLAND_SLEEPING);
    object->setUserIndex(static_cast<int>(surface));
    objects_.push_back(std::move(object));
}

} // namespace usar::sim
