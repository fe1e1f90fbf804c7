#include "core/sim/physics.h"

#include <algorithm>
#include <limits>
#include <map>

#include <btBulletDynamicsCommon.h>

#include "core/sim/bullet_ground.h"

namespace usar::sim {

namespace {

constexpr int ground_group = 1;
constexpr int body_group = 2;
constexpr double part_margin_m = 0.005;
constexpr double stuck_depth_m = 0.01;
constexpr double sleepy_m_s = 0.02;
constexpr double sleepy_rad_s = 0.02;

std::unique_ptr<btCollisionShape> makeShape(const CylinderShape& shape) {
    return std::make_unique<btCylinderShapeZ>(btVector3(shape.radius_m, shape.radius_m, shape.height_m / 2.0));
}
std::unique_ptr<btCollisionShape> makeShape(const CapsuleShape& shape) {
    return std::make_unique<btCapsuleShapeZ>(shape.radius_m, shape.height_m);
}
std::unique_ptr<btCollisionShape> makeShape(const BoxShape& shape) {
    return std::make_unique<btBoxShape>(toBullet(Vec3(shape.size_m / 2.0)));
}

/// A body and what Bullet wants kept alive for it. `velocity` and `rate` are those before the step.
struct Body {
    std::vector<std::unique_ptr<btCollisionShape>> parts;
    std::unique_ptr<btCompoundShape> shape;
    std::unique_ptr<btRigidBody> rigid;
    std::vector<Contact> contacts;
    double radius_m = 0.0; ///< of a sphere around the origin that holds it
    btVector3 velocity{0.0, 0.0, 0.0};
    btVector3 rate{0.0, 0.0, 0.0};
};

btVector3 velocityAt(const Body& body, const btVector3& point) {
    return body.velocity + body.rate.cross(point - body.rigid->getWorldTransform().getOrigin());
}

Body makeBody(const BodyDescription& description) {
    Body body;
    body.shape = std::make_unique<btCompoundShape>(true, static_cast<int>(description.parts.size()));
    for (const BodyPart& part : description.parts) {
        auto shape = std::visit([](const auto& one) { return makeShape(one); }, part.shape);
        if (!std::holds_alternative<CapsuleShape>(part.shape)) // a capsule's margin is its radius
            shape->setMargin(part_margin_m);
        body.shape->addChildShape(toBullet(part.part_in_body), shape.get());
        body.parts.push_back(std::move(shape));
    }
    btVector3 low;
    btVector3 high;
    body.shape->getAabb(btTransform::getIdentity(), low, high);
    body.radius_m = low.absolute().length() > high.absolute().length() ? low.length() : high.length();
    btRigidBody::btRigidBodyConstructionInfo info(description.mass_kg, nullptr, body.shape.get(),
                                                  toBullet(description.inertia_kg_m2));
    info.m_friction = description.friction;
    info.m_restitution = 0.0;
    body.rigid = std::make_unique<btRigidBody>(info);
    body.rigid->setActivationState(DISABLE_DEACTIVATION);
    return body;
}

struct DeepestContact : btCollisionWorld::ContactResultCallback {
    double depth_m = 0.0;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
        depth_m = std::max(depth_m, -point.getDistance());
        return 0.0;
    }
};

class BulletPhysics : public Physics {
public:
    explicit BulletPhysics(const World& world);
    ~BulletPhysics() override;

    BodyId add(const BodyDescription& description, const Pose& body_in_map) override;
    void remove(BodyId body) override;
    void place(BodyId body, const Pose& body_in_map) override;
    void letSleep(BodyId body, bool allowed) override;
    bool isStuck(BodyId body) override;
    BodyState state(BodyId body) const override;
    void apply(BodyId body, const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) override;
    void step(Seconds dt) override;
    std::span<const Contact> contacts(BodyId body) const override { return bodies_.at(body).contacts; }
    double castAtBodies(const Vec3& origin_m, const Vec3& direction, double maximum_m, BodyId except) const override;
    double distanceToBodies_m(const Vec3& point_m, BodyId except) const override;

private:
    void collectContacts();
    void record(const btPersistentManifold& manifold, const btManifoldPoint& point);

    const Terrain& terrain_;
    BulletGround ground_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld dynamics_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::map<BodyId, Body> bodies_;
    BodyId last_;
};

BulletPhysics::BulletPhysics(const World& world) : terrain_(world.terrain), ground_(world) {
    dynamics_.setGravity({0.0, 0.0, -gravity_m_s2});
    dynamics_.setForceUpdateAllAabbs(false);
    for (const auto& object : ground_.objects())
        dynamics_.addCollisionObject(object.get(), ground_group, body_group);
}

BulletPhysics::~BulletPhysics() {
    for (auto& [id, body] : bodies_)
        dynamics_.removeRigidBody(body.rigid.get());
    for (const auto& object : ground_.objects())
        dynamics_.removeCollisionObject(object.get());
}

BodyId BulletPhysics::add(const BodyDescription& description, const Pose& body_in_map) {
    const BodyId id{++last_.value};
    Body& body = bodies_.emplace(id, makeBody(description)).first->second;
    body.rigid->setUserIndex(static_cast<int>(Surface::Body));
    body.rigid->setUserIndex2(static_cast<int>(id.value));
    body.rigid->setWorldTransform(toBullet(body_in_map));
    body.rigid->setInterpolationWorldTransform(toBullet(body_in_map));
    dynamics_.addRigidBody(body.rigid.get(), body_group, ground_group | body_group);
    return id;
}

void BulletPhysics::remove(BodyId id) {
    dynamics_.removeRigidBody(bodies_.at(id).rigid.get());
    bodies_.erase(id);
}

void BulletPhysics::place(BodyId id, const Pose& body_in_map) {
    Body& body = bodies_.at(id);
    body.rigid->setWorldTransform(toBullet(body_in_map));
    body.rigid->setInterpolationWorldTransform(toBullet(body_in_map));
    body.rigid->setLinearVelocity({0.0, 0.0, 0.0});
    body.rigid->setAngularVelocity({0.0, 0.0, 0.0});
    body.rigid->clearForces();
    dynamics_.updateSingleAabb(body.rigid.get());
}

void BulletPhysics::letSleep(BodyId id, bool allowed) {
    btRigidBody& rigid = *bodies_.at(id).rigid;
    rigid.setSleepingThresholds(sleepy_m_s, sleepy_rad_s);
    rigid.setDeactivationTime(0.0);
    rigid.forceActivationState(allowed ? ACTIVE_TAG : DISABLE_DEACTIVATION);
}

bool BulletPhysics::isStuck(BodyId id) {
    btRigidBody* const rigid = bodies_.at(id).rigid.get();
    const Vec3 position_m = fromBullet(rigid->getWorldTransform().getOrigin());
    const Vec2 point_m = position_m.head<2>();
    // The height field is a thin sheet to Bullet: a body wholly beneath it touches nothing.
    if (!terrain_.empty() && terrain_.extent().contains(point_m) && position_m.z() < terrain_.height_m(point_m))
        return true;
    DeepestContact deepest;
    for (const auto& object : ground_.objects())
        dynamics_.contactPairTest(rigid, object.get(), deepest);
    for (const auto& [other, body] : bodies_)
        if (other != id)
            dynamics_.contactPairTest(rigid, body.rigid.get(), deepest);
    return deepest.depth_m > stuck_depth_m;
}

BodyState BulletPhysics::state(BodyId id) const {
    const btRigidBody& rigid = *bodies_.at(id).rigid;
    const btTransform& transform = rigid.getWorldTransform();
    const btQuaternion q = transform.getRotation();
    return {fromBullet(transform.getOrigin()), Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()),
            fromBullet(rigid.getLinearVelocity()), fromBullet(rigid.getAngularVelocity())};
}

void BulletPhysics::apply(BodyId id, const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) {
    btRigidBody& rigid = *bodies_.at(id).rigid;
    rigid.applyCentralForce(toBullet(force_in_map_n));
    rigid.applyTorque(toBullet(torque_in_map_n_m));
}

void BulletPhysics::step(Seconds dt) {
    for (auto& [id, body] : bodies_) {
        body.contacts.clear();
        body.velocity = body.rigid->getLinearVelocity();
        body.rate = body.rigid->getAngularVelocity();
    }
    dynamics_.stepSimulation(dt.count(), 0);
    collectContacts();
}

void BulletPhysics::collectContacts() {
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
        for (int k = 0; k < manifold.getNumContacts(); ++k)
            if (manifold.getContactPoint(k).getAppliedImpulse() > 0.0)
                record(manifold, manifold.getContactPoint(k));
    }
}

void BulletPhysics::record(const btPersistentManifold& manifold, const btManifoldPoint& point) {
    const btCollisionObject* const pair[2] = {manifold.getBody0(), manifold.getBody1()};
    Body* bodies[2] = {nullptr, nullptr};
    btVector3 velocity[2] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    const btVector3 at[2] = {point.getPositionWorldOnA(), point.getPositionWorldOnB()};
    for (int side = 0; side < 2; ++side) {
        if (pair[side]->getUserIndex() != static_cast<int>(Surface::Body))
            continue;
        bodies[side] = &bodies_.at(BodyId{static_cast<std::uint32_t>(pair[side]->getUserIndex2())});
        velocity[side] = velocityAt(*bodies[side], at[side]);
    }
    // Bullet's normal points from the second body to the first.
    const double closing_speed_m_s = (velocity[1] - velocity[0]).dot(point.m_normalWorldOnB);
    for (int side = 0; side < 2; ++side) {
        if (!bodies[side])
            continue;
        const btVector3 in_body = pair[side]->getWorldTransform().invXform(at[side]);
        bodies[side]->contacts.push_back({static_cast<Surface>(pair[1 - side]->getUserIndex()), fromBullet(in_body),
                                          point.getAppliedImpulse(), closing_speed_m_s});
    }
}

double BulletPhysics::castAtBodies(const Vec3& origin_m, const Vec3& direction, double maximum_m, BodyId except) const {
    const btVector3 from = toBullet(origin_m);
    const btVector3 along = toBullet(direction);
    btTransform start(btQuaternion::getIdentity(), from);
    btTransform end(btQuaternion::getIdentity(), from + maximum_m * along);
    btCollisionWorld::ClosestRayResultCallback nearest(start.getOrigin(), end.getOrigin());
    for (const auto& [id, body] : bodies_) {
        const btTransform& place = body.rigid->getWorldTransform();
        const btVector3 toward = place.getOrigin() - from;
        const double closest_m = std::clamp(toward.dot(along), 0.0, maximum_m);
        if (id != except && (toward - closest_m * along).length2() <= body.radius_m * body.radius_m)
            btCollisionWorld::rayTestSingle(start, end, body.rigid.get(), body.shape.get(), place, nearest);
    }
    return nearest.hasHit() ? maximum_m * nearest.m_closestHitFraction : maximum_m;
}

double BulletPhysics::distanceToBodies_m(const Vec3& point_m, BodyId except) const {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const auto& [id, body] : bodies_)
        if (id != except)
            nearest_m = std::min(nearest_m, (fromBullet(body.rigid->getWorldTransform().getOrigin()) - point_m).norm());
    return nearest_m;
}

} // namespace

std::unique_ptr<Physics> makePhysics(const World& world) {
    return std::make_unique<BulletPhysics>(world);
}

} // namespace usar::sim
