#include "core/sim/physics/physics.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "core/sim/physics/bullet_ground.h"
#include "core/sim/physics/bullet_multi_body.h"
#include "core/sim/physics/bullet_rigid_body.h"
#include "core/sim/physics/bullet_world.h"
#include "core/sim/physics/flat_ground.h"
#include "core/sim/physics/free_flight.h"
#include "core/sim/rays/body_index.h"

namespace usar::sim {

namespace {

constexpr double stuck_depth_m = 0.01;
constexpr double wake_margin_m = 0.1;
constexpr double bouncing_m_s = 0.1; // Slower impacts do not bounce.

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
    explicit BulletPhysics(const World& world) : terrain_(world.terrain), ground_(world) {
        dynamics_.setGravity({0.0, 0.0, -gravity_m_s2});
        for (const auto& object : ground_.objects())
            dynamics_.addCollisionObject(object.get(), ground_group, body_group);
    }

    ~BulletPhysics() override {
        bodies_.clear();
        for (const auto& object : ground_.objects())
            dynamics_.removeCollisionObject(object.get());
    }

    BodyId add(const BodyDescription& description, const Pose& body_in_map) override {
        const BodyId id{++last_.value};
        moved_ = true;
        bodies_.emplace(id, std::make_unique<BulletRigidBody>(dynamics_, description, body_in_map, id));
        lookAroundAgain();
        return id;
    }

    BodyId add(const ArticulatedDescription& description, const Pose& base_in_map) override {
        if (description.links.empty())
            return add(description.base, base_in_map);
        const BodyId id{++last_.value};
        moved_ = true;
        bodies_.emplace(id, std::make_unique<BulletMultiBody>(dynamics_, description, base_in_map, id));
        lookAroundAgain();
        return id;
    }

    void remove(BodyId id) override {
        const Space space = spaceOf(*bodies_.at(id));
        bodies_.erase(id);
        moved_ = true;
        wakeIn(space);
    }

    void place(BodyId id, const Pose& body_in_map) override {
        BulletBody& body = *bodies_.at(id);
        const Space left = spaceOf(body);
        body.place(body_in_map);
        body.placed = true;
        moved_ = true;
        lookAroundAgain();
        body.wake();
        wakeIn(left);
        wakeIn(spaceOf(body));
    }

    void letSleep(BodyId id, bool allowed) override { bodies_.at(id)->letSleep(allowed); }
    bool isAsleep(BodyId id) const override { return bodies_.at(id)->asleep(); }

    bool isStuck(BodyId id) override {
        const BulletBody& self = *bodies_.at(id);
        const Vec3 position_m = fromBullet(self.position());
        const Vec2 point_m = position_m.head<2>();
        // To Bullet the height field is a thin sheet: a body entirely beneath it touches nothing.
        if (!terrain_.empty() && terrain_.extent().contains(point_m) && position_m.z() < terrain_.height_m(point_m))
            return true;
        DeepestContact deepest;
        const std::vector<btCollisionObject*> near = objectsIn(spaceOf(self));
        for (const BulletPiece& piece : self.pieces())
            for (btCollisionObject* const other : near)
                if (bodyOf(*other) != &self)
                    dynamics_.contactPairTest(piece.object, other, deepest);
        return deepest.depth_m > stuck_depth_m;
    }

    BodyState state(BodyId id) const override { return bodies_.at(id)->state(-1); }
    BodyState state(BodyId id, std::size_t link) const override {
        return bodies_.at(id)->state(static_cast<int>(link));
    }
    JointState joint(BodyId id, std::size_t link) const override { return bodies_.at(id)->joint(link); }
    void setMotor(BodyId id, std::size_t link, const JointMotor& motor) override {
        bodies_.at(id)->setMotor(link, motor);
    }
    void runSurface(BodyId id, const Vec3& velocity_in_body_m_s) override {
        bodies_.at(id)->runSurface(velocity_in_body_m_s);
        wakeIn(spaceOf(*bodies_.at(id)));
    }
    void apply(BodyId id, const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) override {
        BulletBody& body = *bodies_.at(id);
        if (!body.asleep()) // Bullet would add it up until the body wakes.
            body.apply(force_in_map_n, torque_in_map_n_m);
    }

    void step(Seconds dt) override {
        awake_.clear();
        for (auto& [id, body] : bodies_) {
            body->contacts.clear();
            if (!body->asleep())
                awake_.push_back(body.get());
        }
        if (awake_.empty())
            return; // Nothing would move.
        moved_ = true;
        for (BulletBody* const body : awake_)
            body->beforeStep(dt);
        const bool flew = free_flight_.step(awake_, dt);
        boxes_are_old_ |= flew;
        if (!flew) {
            dynamics_.stepSimulation(dt.count(), 0);
            boxes_are_old_ = false;
            collectContacts();
            // What drives or falls may come to rest where a flying body has looked before.
            if (std::ranges::any_of(awake_, [](BulletBody* body) { return body->flying() == nullptr; }))
                for (BulletBody* const body : awake_)
                    body->free_space.known = false;
        }
        for (BulletBody* const body : awake_) {
            body->afterStep();
            if (!flew)
                keepAboveGround(*body);
            body->placed = false;
        }
    }

    std::span<const Contact> contacts(BodyId id) const override { return bodies_.at(id)->contacts; }

    double castAtBodies(const Vec3& origin_m, const Vec3& direction, double maximum_m, double nearest_m,
                        BodyId except) const override {
        if (isAlone(except))
            return nearest_m;
        indexBodies();
        const auto found = bodies_.find(except);
        const BulletBody* const passed = found == bodies_.end() ? nullptr : found->second.get();
        const btTransform start(btQuaternion::getIdentity(), toBullet(origin_m));
        const btTransform end(btQuaternion::getIdentity(), toBullet(origin_m + maximum_m * direction));
        btCollisionWorld::ClosestRayResultCallback met(start.getOrigin(), end.getOrigin());
        return index_.along({origin_m, direction}, nearest_m, [&](const BodySphere& sphere, double so_far_m) {
            const BulletBody& body = *indexed_[sphere.piece];
            if (&body == passed)
                return so_far_m;
            for (const BulletPiece& piece : body.pieces()) {
                const Vec3 toward_m = fromBullet(piece.object->getWorldTransform().getOrigin()) - origin_m;
                const double closest_m = std::clamp(toward_m.dot(direction), 0.0, so_far_m);
                if ((toward_m - closest_m * direction).squaredNorm() > piece.radius_m * piece.radius_m)
                    continue;
                btCollisionWorld::rayTestSingle(start, end, piece.object, piece.object->getCollisionShape(),
                                                piece.object->getWorldTransform(), met);
                if (met.hasHit())
                    so_far_m = std::min(so_far_m, maximum_m * met.m_closestHitFraction);
            }
            return so_far_m;
        });
    }

    bool hasBodies(const Eigen::AlignedBox3d& box_in_map_m, BodyId except) const override {
        if (isAlone(except))
            return false;
        indexBodies();
        const auto found = bodies_.find(except);
        const BulletBody* const passed = found == bodies_.end() ? nullptr : found->second.get();
        return index_.anyIn(box_in_map_m, [&](const BodySphere& sphere) {
            const BulletBody& body = *indexed_[sphere.piece];
            return &body != passed && std::ranges::any_of(body.pieces(), [&](const BulletPiece& piece) {
                return box_in_map_m.squaredExteriorDistance(fromBullet(
                           piece.object->getWorldTransform().getOrigin())) <= piece.radius_m * piece.radius_m;
            });
        });
    }

    bool meetsBox(const Vec3& center_in_map_m, const Eigen::Quaterniond& rotation, const Vec3& size_m,
                  BodyId except) override {
        btBoxShape shape(0.5 * toBullet(size_m));
        btCollisionObject box;
        box.setCollisionShape(&shape);
        box.setWorldTransform(
            btTransform({rotation.x(), rotation.y(), rotation.z(), rotation.w()}, toBullet(center_in_map_m)));
        Space space;
        shape.getAabb(box.getWorldTransform(), space.low, space.high);
        DeepestContact deepest;
        for (btCollisionObject* const other : objectsIn(space)) {
            const BulletBody* const body = bodyOf(*other);
            if (!body || body != bodies_.at(except).get())
                dynamics_.contactPairTest(&box, other, deepest);
        }
        return deepest.depth_m > 0.0;
    }

    double distanceToBodies_m(const Vec3& point_m, BodyId except) const override {
        double nearest_m = std::numeric_limits<double>::infinity();
        for (const auto& [id, body] : bodies_)
            if (id != except)
                nearest_m = std::min(nearest_m, (fromBullet(body->position()) - point_m).norm());
        return nearest_m;
    }

private:
    bool isAlone(BodyId body) const {
        return bodies_.empty() || (bodies_.size() == 1 && bodies_.begin()->first == body);
    }

    void indexBodies() const {
        if (!std::exchange(moved_, false))
            return;
        std::vector<BodySphere> spheres;
        indexed_.clear();
        for (const auto& [id, body] : bodies_) {
            const Vec3 base_m = fromBullet(body->position());
            double reach_m = 0.0;
            for (const BulletPiece& piece : body->pieces()) {
                const Vec3 piece_m = fromBullet(piece.object->getWorldTransform().getOrigin());
                reach_m = std::max(reach_m, (piece_m - base_m).norm() + piece.radius_m);
            }
            spheres.push_back({base_m, reach_m, static_cast<std::uint32_t>(indexed_.size())});
            indexed_.push_back(body.get());
        }
        index_.build(std::move(spheres));
    }

    BulletBody* bodyOf(const btCollisionObject& object) {
        if (object.getUserIndex() != static_cast<int>(Surface::Body))
            return nullptr;
        return bodies_.at(BodyId{static_cast<std::uint32_t>(object.getUserIndex2())}).get();
    }

    /// A box around all pieces of a body.
    struct Space {
        btVector3 low{BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT};
        btVector3 high{-BT_LARGE_FLOAT, -BT_LARGE_FLOAT, -BT_LARGE_FLOAT};
    };

    static Space spaceOf(const BulletBody& body) {
        const btVector3 margin(wake_margin_m, wake_margin_m, wake_margin_m);
        Space space;
        for (const BulletPiece& piece : body.pieces()) {
            btVector3 low;
            btVector3 high;
            piece.object->getCollisionShape()->getAabb(piece.object->getWorldTransform(), low, high);
            space.low.setMin(low - margin);
            space.high.setMax(high + margin);
        }
        return space;
    }

    std::vector<btCollisionObject*> objectsIn(const Space& space) {
        if (std::exchange(boxes_are_old_, false))
            dynamics_.updateAabbs();
        struct Finder : btBroadphaseAabbCallback {
            bool process(const btBroadphaseProxy* proxy) override {
                found.push_back(static_cast<btCollisionObject*>(proxy->m_clientObject));
                return true;
            }
            std::vector<btCollisionObject*> found{};
        } finder;
        broadphase_.aabbTest(space.low, space.high, finder);
        return finder.found;
    }

    // Sleeping bodies wake when they are touched, but not when the thing they lie on goes away. Bullet wakes what is
    // piled on a body that wakes.
    void wakeIn(const Space& space) {
        for (const btCollisionObject* const object : objectsIn(space))
            if (BulletBody* const body = bodyOf(*object))
                body->wake();
    }

    // To Bullet the height field is a thin sheet, but the ground is a solid block: a body that was pressed through it,
    // for example by a car that rolls over it, is lifted out again. A body that was just placed is left where it is.
    void keepAboveGround(BulletBody& body) {
        const Vec3 at_m = fromBullet(body.position());
        if (body.placed || terrain_.empty() || !terrain_.extent().contains(at_m.head<2>()))
            return;
        const double under_m = terrain_.height_m(at_m.head<2>()) - at_m.z();
        if (under_m > 0.0)
            body.lift(under_m);
    }

    void lookAroundAgain() {
        for (const auto& [id, body] : bodies_)
            body->free_space = {};
    }

    static bool moves(const btCollisionObject& object) {
        return !object.isStaticOrKinematicObject() && object.isActive();
    }

    void collectContacts() {
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
            const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
            if (!moves(*manifold.getBody0()) && !moves(*manifold.getBody1()))
                continue; // Nothing pressed on sleeping bodies in this step.
            for (int k = 0; k < manifold.getNumContacts(); ++k)
                if (manifold.getContactPoint(k).getAppliedImpulse() > 0.0)
                    record(manifold, manifold.getContactPoint(k));
        }
    }

    void record(const btPersistentManifold& manifold, const btManifoldPoint& point) {
        const btCollisionObject* const pair[2] = {manifold.getBody0(), manifold.getBody1()};
        BulletBody* const bodies[2] = {bodyOf(*pair[0]), bodyOf(*pair[1])};
        const btVector3 at[2] = {point.getPositionWorldOnA(), point.getPositionWorldOnB()};
        btVector3 velocity[2] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        double restitution = 0.0;
        for (int side = 0; side < 2; ++side) {
            if (!bodies[side])
                continue;
            velocity[side] = bodies[side]->velocityBefore(pair[side]->getUserIndex3(), at[side]);
            restitution = std::max(restitution, bodies[side]->restitution);
        }
        // Bullet's normal points from the second body to the first.
        const double closing_speed_m_s = (velocity[1] - velocity[0]).dot(point.m_normalWorldOnB);
        for (int side = 0; side < 2; ++side) {
            if (!bodies[side])
                continue;
            const btVector3 in_body = pair[side]->getWorldTransform().invXform(at[side]);
            const Vec3 normal = fromBullet(side == 0 ? point.m_normalWorldOnB : -point.m_normalWorldOnB);
            bodies[side]->contacts.push_back({static_cast<Surface>(pair[1 - side]->getUserIndex()), fromBullet(in_body),
                                              point.getAppliedImpulse(), closing_speed_m_s, pair[side]->getUserIndex3(),
                                              normal});
        }
        if (restitution > 0.0 && closing_speed_m_s > bouncing_m_s)
            bounce(manifold, point, restitution * closing_speed_m_s);
    }

    // Bullet reports contacts slightly ahead of time, so its own restitution falls short by the width of the gap. At
    // this point it has brought rigid bodies to the surface; here they get the speed at which they leave it.
    void bounce(const btPersistentManifold& manifold, const btManifoldPoint& point, double separating_m_s) {
        const btRigidBody* const pair[2] = {btRigidBody::upcast(manifold.getBody0()),
                                            btRigidBody::upcast(manifold.getBody1())};
        const btVector3 at[2] = {point.getPositionWorldOnA(), point.getPositionWorldOnB()};
        double speed_m_s = 0.0;
        double mobility = 0.0;
        for (int side = 0; side < 2; ++side) {
            if (!pair[side])
                continue;
            const btVector3 arm = at[side] - pair[side]->getCenterOfMassPosition();
            const double along = pair[side]->getVelocityInLocalPoint(arm).dot(point.m_normalWorldOnB);
            speed_m_s += side == 0 ? along : -along;
            mobility += pair[side]->computeImpulseDenominator(at[side], point.m_normalWorldOnB);
        }
        if (mobility <= 0.0 || speed_m_s >= separating_m_s)
            return;
        const btVector3 impulse = (separating_m_s - speed_m_s) / mobility * point.m_normalWorldOnB;
        for (int side = 0; side < 2; ++side)
            if (pair[side])
                const_cast<btRigidBody*>(pair[side])
                    ->applyImpulse(side == 0 ? impulse : -impulse, at[side] - pair[side]->getCenterOfMassPosition());
    }

    const Terrain& terrain_;
    BulletGround ground_;
    GroundConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver rigid_solver_;
    BulletSolver link_solver_;
    BulletWorld dynamics_{dispatcher_, broadphase_, rigid_solver_, link_solver_, configuration_};
    FreeFlight free_flight_{dynamics_, broadphase_, terrain_};
    bool boxes_are_old_ = false; ///< Bodies have flown without the broadphase's knowledge.
    std::map<BodyId, std::unique_ptr<BulletBody>> bodies_;
    BodyId last_;
    std::vector<BulletBody*> awake_; ///< bodies that the current step may move
    // Rebuilt when a ray asks for it, so that steps without rays cost nothing.
    mutable BodyIndex index_;
    mutable std::vector<const BulletBody*> indexed_; ///< index: BodySphere::piece
    mutable bool moved_ = true;
};

} // namespace

std::unique_ptr<Physics> makePhysics(const World& world) {
    return std::make_unique<BulletPhysics>(world);
}

} // namespace usar::sim
