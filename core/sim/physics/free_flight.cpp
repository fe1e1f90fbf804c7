#include "core/sim/physics/free_flight.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/sim/physics/bullet_ground.h"

namespace usar::sim {

namespace {

/// How far a body may fly before it looks around again; less where something is too near for that.
constexpr double free_travel_m = 0.3;
constexpr double short_travel_m = 0.12;
/// Another body may have moved as far before it looked around, and as far after.
constexpr double reach_m = 3.0 * free_travel_m;
/// Bullet brings bodies closer than this to its solver already.
constexpr double gap_m = 0.05;
/// A body with something near it looks again after so many steps. A look costs a tenth of a step of Bullet.
constexpr int steps_until_next_look = 3;

struct ObjectsWithin : btBroadphaseAabbCallback {
    bool process(const btBroadphaseProxy* proxy) override {
        objects.push_back(static_cast<btCollisionObject*>(proxy->m_clientObject));
        return true;
    }
    std::vector<btCollisionObject*> objects{};
};

/// The numbers of those parts of a compound whose boxes were met.
struct PartsWithin : btDbvt::ICollide {
    void Process(const btDbvtNode* leaf) override { parts.push_back(leaf->dataAsInt); }
    std::vector<int> parts{};
};

/// Distance from a point to a rectangle around the origin with these half sides; 0 inside.
template <class Vector>
double outside(const Vector& point_m, const Vector& half_m) {
    return (point_m.cwiseAbs() - half_m).cwiseMax(0.0).norm();
}

/// Distance from a point in the frame of a cone, whose base is at the origin, to its surface; 0 inside.
double fromCone(const Vec2& out_and_up_m, double radius_m, double height_m) {
    if (out_and_up_m.y() <= 0.0)
        return outside(out_and_up_m, Vec2(radius_m, 0.0));
    const Vec2 rim_m(radius_m, 0.0);
    const Vec2 side = Vec2(-radius_m, height_m).normalized();
    const Vec2 from_rim_m = out_and_up_m - rim_m;
    const double along_m = std::clamp(from_rim_m.dot(side), 0.0, std::hypot(radius_m, height_m));
    const bool inside = side.x() * from_rim_m.y() - side.y() * from_rim_m.x() > 0.0;
    return inside ? 0.0 : (from_rim_m - along_m * side).norm();
}

/// Distance from a point in the shape's frame to the shape, or less: Bullet's cones have twelve sides. Below a cone it
/// is more by the margin of 1 mm, which `gap_m` has room for. It is 0 for a shape that no ground has.
double distanceTo(const btCollisionShape& shape, const btVector3& point) {
    const Vec3 point_m = fromBullet(point);
    const Vec2 out_and_up_m(point_m.head<2>().norm(), point_m.z());
    switch (shape.getShapeType()) {
    case BOX_SHAPE_PROXYTYPE:
        return outside(point_m, fromBullet(static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin()));
    case CYLINDER_SHAPE_PROXYTYPE: {
        const btVector3 half = static_cast<const btCylinderShape&>(shape).getHalfExtentsWithMargin();
        return outside(out_and_up_m, Vec2(half.x(), half.z()));
    }
    case SPHERE_SHAPE_PROXYTYPE:
        return point_m.norm() - static_cast<const btSphereShape&>(shape).getRadius();
    case CONVEX_HULL_SHAPE_PROXYTYPE: { // Only cones are hulls here.
        btVector3 low, high;
        shape.getAabb(btTransform::getIdentity(), low, high);
        return fromCone(out_and_up_m, high.x(), high.z());
    }
    default:
        return 0.0;
    }
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
    const auto stays = [&] { return space.known && body.position().distance(space.center) + next_m < space.travel_m; };
    if (stays())
        return true;
    if (space.steps_to_wait > 0) {
        --space.steps_to_wait;
        return false;
    }
    space = {.known = hasNothingNear(body, free_travel_m), .center = body.position(), .travel_m = free_travel_m};
    if (!space.known)
        space = {.known = hasNothingNear(body, short_travel_m), .center = body.position(), .travel_m = short_travel_m};
    if (!space.known)
        space.steps_to_wait = steps_until_next_look;
    return stays();
}

bool FreeFlight::hasNothingNear(const BulletBody& body, double travel_m) {
    const BulletPiece& piece = body.pieces().front();
    const auto boxAround = [&](double radius_m, btVector3& low, btVector3& high) {
        const btVector3 half(radius_m, radius_m, radius_m);
        low = body.position() - half;
        high = body.position() + half;
    };
    btVector3 low, high;
    boxAround(piece.radius_m + travel_m, low, high);
    if (!isAboveGround(low, high))
        return false;
    boxAround(piece.radius_m + reach_m, low, high);
    world_.updateAabbs(); // The others may have flown freely, too.
    ObjectsWithin near;
    broadphase_.aabbTest(low, high, near);
    return std::ranges::none_of(near.objects, [&](btCollisionObject* object) {
        if (object == piece.object || object->getUserIndex() == static_cast<int>(Surface::Ground))
            return false;
        if (object->getUserIndex() == static_cast<int>(Surface::Body))
            return mayTouch(*object, body.position(), piece.radius_m + reach_m);
        return reaches(*object, body.position(), piece.radius_m + travel_m);
    });
}

bool FreeFlight::reaches(btCollisionObject& object, const btVector3& center, double radius_m) {
    const btVector3 point = object.getWorldTransform().invXform(center);
    const btCollisionShape& shape = *object.getCollisionShape();
    if (!shape.isCompound())
        return distanceTo(shape, point) < radius_m;
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    const btVector3 half(radius_m, radius_m, radius_m);
    const btDbvt& tree = *compound.getDynamicAabbTree();
    PartsWithin near;
    tree.collideTV(tree.m_root, btDbvtVolume::FromMM(point - half, point + half), near);
    return std::ranges::any_of(near.parts, [&](int part) {
        return distanceTo(*compound.getChildShape(part), compound.getChildTransform(part).invXform(point)) < radius_m;
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
