// A world's fixed parts as Bullet collision objects: a height field, one compound of plants, one of boxes. Internal to
// the physics: only the bullet_* headers include Bullet.
#pragma once

#include <memory>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "core/sim/physics/physics.h"

namespace usar::sim {

static_assert(sizeof(btScalar) == 8, "link PkgConfig::BULLET64: the single-precision build is not accurate enough");

inline btVector3 toBullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}
inline Vec3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
btTransform toBullet(const Pose& pose);
/// State from Bullet's transform and velocities, all in the map frame.
BodyState bodyState(const btTransform& body_in_map, const btVector3& velocity_m_s, const btVector3& rate_rad_s);

/// Owns shapes and objects; each object's user index is its Surface. One compound for all plants makes a step of an
/// empty world six times cheaper than 4000 separate bodies (robots-and-worlds.md 6).
class BulletGround {
public:
    /// `world` must outlive it: its heights are not copied.
    explicit BulletGround(const World& world);

    /// Objects for the dynamics world; valid as long as this exists.
    const std::vector<std::unique_ptr<btCollisionObject>>& objects() const { return objects_; }

private:
    void addTerrain(const Terrain& terrain);
    void addPlants(const std::vector<Plant>& plants);
    void addBoxes(const std::vector<Box>& boxes);
    void addObject(btCollisionShape* shape, const btTransform& place, Surface surface);
    template <class Shape, class... Arguments>
    Shape* keep(Arguments&&... arguments);

    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

} // namespace usar::sim
