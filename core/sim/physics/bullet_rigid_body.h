// One rigid body in Bullet. Internal to the physics.
#pragma once

#include <algorithm>
#include <memory>

#include <btBulletDynamicsCommon.h>

#include "core/sim/physics/bullet_body.h"
#include "core/sim/physics/bullet_ground.h"

namespace usar::sim {

/// A still body becomes a kinematic object of Bullet.
class BulletRigidBody : public BulletBody {
public:
    /// `world` must outlive it.
    BulletRigidBody(btDynamicsWorld& world, const BodyDescription& description, const Pose& body_in_map, BodyId id)
        : world_(world)
        , shape_(description)
        , rest_rad_s_(description.rest_rad_s) {
        const double mass_kg = description.still ? 0.0 : description.mass_kg;
        const Vec3 inertia_kg_m2 = description.still ? Vec3(Vec3::Zero()) : description.inertia_kg_m2;
        const btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, shape_.compound(),
                                                            toBullet(inertia_kg_m2));
        rigid_ = std::make_unique<btRigidBody>(info);
        if (description.still)
            rigid_->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
        markAsBody(*rigid_, description, id, -1);
        rigid_->setWorldTransform(toBullet(body_in_map));
        rigid_->setInterpolationWorldTransform(toBullet(body_in_map));
        world_.addRigidBody(rigid_.get(), body_group, ground_group | body_group);
        restitution = description.restitution;
        pieces_ = {{rigid_.get(), shape_.radius_m()}};
    }
    ~BulletRigidBody() override { world_.removeRigidBody(rigid_.get()); }
    BulletRigidBody(const BulletRigidBody&) = delete;
    BulletRigidBody& operator=(const BulletRigidBody&) = delete;

    /// Also stops the body, so that it does not go on as before from its new place.
    void place(const Pose& body_in_map) override {
        rigid_->setWorldTransform(toBullet(body_in_map));
        rigid_->setInterpolationWorldTransform(toBullet(body_in_map));
        rigid_->setLinearVelocity({0.0, 0.0, 0.0});
        rigid_->setAngularVelocity({0.0, 0.0, 0.0});
        rigid_->clearForces();
        world_.updateSingleAabb(rigid_.get());
    }
    /// Takes away downward speed but keeps upward speed; a still body stays where it is.
    void lift(double height_m) override {
        if (rigid_->isStaticOrKinematicObject())
            return;
        rigid_->translate({0.0, 0.0, height_m});
        btVector3 velocity = rigid_->getLinearVelocity();
        velocity.setZ(std::max(velocity.z(), 0.0));
        rigid_->setLinearVelocity(velocity);
        world_.updateSingleAabb(rigid_.get());
    }
    /// Begins to count the time at rest from 0.
    void letSleep(bool allowed) override {
        rigid_->setSleepingThresholds(sleepy_m_s, rest_rad_s_);
        rigid_->setDeactivationTime(0.0);
        rigid_->forceActivationState(allowed ? ACTIVE_TAG : DISABLE_DEACTIVATION);
    }
    /// Begins to count the time at rest from 0, like letSleep().
    void wake() override {
        rigid_->activate();
        in_place_ = Seconds{0.0};
    }
    btRigidBody* flying() override {
        const bool flies = !rigid_->isStaticOrKinematicObject() && rigid_->getActivationState() == DISABLE_DEACTIVATION;
        return flies ? rigid_.get() : nullptr;
    }
    /// A rigid body has no links, so the number is ignored.
    BodyState state(int /*link*/) const override {
        return bodyState(rigid_->getWorldTransform(), rigid_->getLinearVelocity(), rigid_->getAngularVelocity());
    }
    /// Takes effect for a still body only, from the next step on.
    void runSurface(const Vec3& velocity_in_body_m_s) override { surface_ = toBullet(velocity_in_body_m_s); }
    /// The force acts at the center of mass. Both add up until Bullet clears them.
    void apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) override {
        rigid_->applyCentralForce(toBullet(force_in_map_n));
        rigid_->applyTorque(toBullet(torque_in_map_n_m));
    }
    void beforeStep(Seconds dt) override {
        // Bullet takes a kinematic body's velocity from where it was before the step, and never moves the body. So a
        // body that claims to have been elsewhere drags along what touches it, and stays in place.
        if (rigid_->isKinematicObject()) {
            btTransform before = rigid_->getWorldTransform();
            before.setOrigin(before.getOrigin() - before.getBasis() * surface_ * dt.count());
            rigid_->setInterpolationWorldTransform(before);
        }
        velocity_ = rigid_->getLinearVelocity();
        rate_ = rigid_->getAngularVelocity();
        in_place_ += dt;
    }
    /// Bullet moves the body itself. But contacts at the edges of triangles keep some bodies trembling, and Bullet does
    /// not let what trembles sleep. Here a body that may sleep does so once it has stayed in its place for long enough.
    void afterStep() override {
        if (rigid_->isStaticOrKinematicObject())
            return;
        const int state = rigid_->getActivationState();
        const btTransform& now = rigid_->getWorldTransform();
        if (state == DISABLE_DEACTIVATION || state == ISLAND_SLEEPING || hasMoved(now)) {
            place_ = now;
            in_place_ = Seconds{0.0};
        } else if (in_place_ >= rest_time) {
            rigid_->setActivationState(WANTS_DEACTIVATION);
        }
    }
    /// Velocity in m/s of the point of the body that is at `point` in the map frame, before the step.
    btVector3 velocityBefore(int /*link*/, const btVector3& point) const override {
        return velocity_ + rate_.cross(point - rigid_->getWorldTransform().getOrigin());
    }

private:
    static constexpr Seconds rest_time{2.0}; ///< Bullet's own figure, too
    static constexpr double rest_m = 0.002;
    static constexpr double rest_rad = 0.01;

    bool hasMoved(const btTransform& now) const {
        const btVector3 along_x = now.getBasis().getColumn(0) - place_.getBasis().getColumn(0);
        const btVector3 along_y = now.getBasis().getColumn(1) - place_.getBasis().getColumn(1);
        return now.getOrigin().distance2(place_.getOrigin()) > rest_m * rest_m ||
               std::max(along_x.length2(), along_y.length2()) > rest_rad * rest_rad;
    }

    /// Bullet's world refers to the body, so the destructor takes it out of there first.
    btDynamicsWorld& world_;
    BulletShape shape_;
    double rest_rad_s_;
    std::unique_ptr<btRigidBody> rigid_;
    btTransform place_ = btTransform::getIdentity(); ///< where it was when it moved last
    Seconds in_place_{0.0};                          ///< since then
    btVector3 velocity_{0.0, 0.0, 0.0};              ///< before the step, like `rate_`
    btVector3 rate_{0.0, 0.0, 0.0};
    btVector3 surface_{0.0, 0.0, 0.0}; ///< velocity of a still body's surface, in its frame
};

} // namespace usar::sim
