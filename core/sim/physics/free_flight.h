// Steps of bodies that have nothing near them. Internal to the physics.
#pragma once

#include <span>

#include <btBulletDynamicsCommon.h>

#include "core/sim/physics/bullet_body.h"
#include "core/sim/world/terrain.h"

namespace usar::sim {

/// Moves bodies that can touch nothing just as Bullet's world would, bit for bit, but without its search for contacts
/// and its solver, which take most of the time of a robot that flies alone.
///
/// A body is clear while nothing that stands is within its sphere enlarged by 0.3 m, and no other body within its
/// sphere enlarged by 0.9 m. It stays clear until it has moved by 0.3 m: if another flying body does the same, they
/// cannot meet. Whoever adds or places a body, or lets Bullet move one that does not fly, must make all bodies forget
/// their FreeSpace.
class FreeFlight {
public:
    /// All must outlive it.
    FreeFlight(btCollisionWorld& world, btBroadphaseInterface& broadphase, const Terrain& terrain)
        : world_(world)
        , broadphase_(broadphase)
        , terrain_(terrain) {}

    /// Moves all bodies, which are those that are awake, and returns true; or moves none and returns false, because one
    /// of them may touch something in a step of this length. Leaves the bodies' boxes in the broadphase where they
    /// were.
    bool step(std::span<BulletBody* const> awake, Seconds dt);

private:
    bool isClear(BulletBody& body, Seconds dt);
    /// Nothing can touch the body, however it turns, while it flies less than this far.
    bool hasNothingNear(const BulletBody& body, double travel_m);
    /// `center` and `radius_m` are of a sphere in the map frame.
    bool reaches(btCollisionObject& object, const btVector3& center, double radius_m);
    bool isAboveGround(const btVector3& low, const btVector3& high) const;

    btCollisionWorld& world_;
    btBroadphaseInterface& broadphase_;
    const Terrain& terrain_;
};

} // namespace usar::sim
