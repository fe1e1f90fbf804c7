#include "core/sim/physics/free_flight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/sim/physics/bullet_ground.h"

namespace usar::sim {

namespace {

constexpr double reach_m = 0.9;
/// Two bodies may each have moved this far before and after the other one looked around.
constexpr double free_travel_m = reach_m / 3.0;
/// Bullet brings bodies closer than this to its solver already.
constexpr double gap_m = 0.05;
/// A body with something near it looks again after so many steps: looking costs more than a few steps of Bullet.
constexpr int steps_until_next_look = 12;

struct AnyContact : btCollisionWorld::ContactResultCallback {
    bool found = false;
    btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
        found = true;
        return 0.0;
    }
};

struct ObjectsWithin : btBroadphaseAabbCallback {
    bool process(const btBroadphaseProxy* proxy) override {
        objects.push_back(static_cast<btCollisionObject*>(proxy->m_clientObject));
        return true;
    }
    std::vector<btCollisionObject*> objects{};
};

struct AnyLeaf : btDbvt::ICollide {
    bool found = false;
    void Process(const btDbvtNode*) override { found = true; }
};

/// True if the box around a part of the compound, which must be at the origin of the map frame, meets this box.
bool anyPartIn(const btCompoundShape& compound, const btVector3& low, const btVector3& high) {
    AnyLeaf leaf;
    compound.getDynamicAabbTree()->collideTV(compound.getDynamicAabbTree()->m_root, btDbvtVolume::FromMM(low, high),
                                             leaf);
    return leaf.found;
}

/// True if the object can touch this sphere, however it turns around its origin.
bool mayTouch(const btCollisionObject& object, const btVector3& center, double radius_m) {
    btVector3 middle;
    btScalar object_radius_m = 0.0;
    object.getCollisionShape()->getBoundingSphere(middle, object_radius_m);
    const double reach = radius_m + middle.length() + object_radius_m;
    return object.getWorldTransform().getOrigin().distance2(center) < reach * reach;
}

/// Bullet's own step for a body without contacts: predictUnconstraintMotion, the solver's way of adding forces, and
/// integrateTransforms, in their order.
void move(btRigidBody& body, double dt_s) {
    body.applyGravity();
    body.applyDamping(dt_s);
    const btVector3 push_m_s = body.getTotalForce() * body.getInvMass() * dt_s;
    btVector3 turn_rad_s = body.getTotalTorque() * body.getInvInertiaTensorWorld() * dt_s;
    if (body.getFlags() & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY)
        turn_rad_s += body.computeGyroscopicImpulseImplicit_Body(dt_s);
    body.setLinearVelocity(body.getLinearVelocity() + push_m_s);
    body.setAngularVelocity(body.getAngularVelocity() + turn_rad_s);
    btTransform moved;
    body.predictIntegratedTransform(dt_s, moved);
    body.proceedToTransform(moved);
    body.clearForces();
}

} // namespace

bool FreeFlight::step(std::span<BulletBody* const> awake, Seconds dt) {
    if (!std::ranges::all_of(awake, [&](BulletBody* body) { return isClear(*body, dt); }))
        return false;
    for (BulletBody* const body : awake)
        move(*body->flying(), dt.count());
    return true;
}

/// Looks around again when the body has come to the end of the space in which it is known to be clear.
bool FreeFlight::isClear(BulletBody& body, Seconds dt) {
    const btRigidBody* const rigid = body.flying();
    if (!rigid)
        return false;
    FreeSpace& space = body.free_space;
    const double next_m = rigid->getLinearVelocity().length() * dt.count() + gap_m;
    const auto stays = [&] { return space.known && body.position().distance(space.center) + next_m < free_travel_m; };
    if (stays())
        return true;
    if (space.steps_to_wait > 0) {
        --space.steps_to_wait;
        return false;
    }
    space = {.known = hasNothingNear(body), .center = body.position()};
    if (!space.known)
        space.steps_to_wait = steps_until_next_look;
    return stays();
}

bool FreeFlight::hasNothingNear(const BulletBody& body) {
    const BulletPiece& piece = body.pieces().front();
    btSphereShape sphere(piece.radius_m + reach_m);
    btCollisionObject around;
    around.setCollisionShape(&sphere);
    around.setWorldTransform(btTransform(btQuaternion::getIdentity(), body.position()));
    const btVector3 half(sphere.getRadius(), sphere.getRadius(), sphere.getRadius());
    const btVector3 low = body.position() - half;
    const btVector3 high = body.position() + half;
    if (!isAboveGround(low, high))
        return false;
    world_.updateAabbs(); // The others may have flown freely, too.
    ObjectsWithin near;
    broadphase_.aabbTest(low, high, near);
    return std::ranges::none_of(near.objects, [&](btCollisionObject* object) {
        if (object == piece.object || object->getUserIndex() == static_cast<int>(Surface::Ground))
            return false;
        const bool is_plants = object->getUserIndex() == static_cast<int>(Surface::Plant);
        if (is_plants && !anyPartIn(static_cast<const btCompoundShape&>(*object->getCollisionShape()), low, high))
            return false; // Nearly always, and found out much sooner.
        if (object->getUserIndex() == static_cast<int>(Surface::Body))
            return mayTouch(*object, body.position(), sphere.getRadius());
        AnyContact contact;
        world_.contactPairTest(&around, object, contact);
        return contact.found;
    });
}

/// True if no post under the box reaches it. Where the terrain ends, there is nothing.
bool FreeFlight::isAboveGround(const btVector3& low, const btVector3& high) const {
    if (terrain_.empty())
        return true;
    const auto postAt = [&](double along_m, std::size_t posts, double round_up) {
        const double index = std::floor(along_m / terrain_.step_m()) + round_up;
        return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(posts - 1)));
    };
    const Vec2 origin_m = terrain_.origin_m();
    const std::size_t last_column = postAt(high.x() - origin_m.x(), terrain_.columns(), 1.0);
    const std::size_t last_row = postAt(high.y() - origin_m.y(), terrain_.rows(), 1.0);
    for (std::size_t row = postAt(low.y() - origin_m.y(), terrain_.rows(), 0.0); row <= last_row; ++row)
        for (std::size_t column = postAt(low.x() - origin_m.x(), terrain_.columns(), 0.0); column <= last_column;
             ++column)
            if (terrain_.post_m(column, row) >= low.z())
                return false;
    return true;
}

} // namespace usar::sim
