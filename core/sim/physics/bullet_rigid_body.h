// One rigid body in Bullet. Internal to the physics.
#pragma once

#include <memory>

#include <btBulletDynamicsCommon.h>

#include "core/sim/physics/bullet_body.h"
#include "core/sim/physics/bullet_ground.h"
#include "core/sim/physics/bullet_shapes.h"

namespace usar::sim {

/// A still body becomes a kinematic object of Bullet.
class BulletRigidBody : public BulletBody {
public:
    /// `world` must outlive it.
    BulletRigidBody(btDynamicsWorld& world, const BodyDescription& description, const Pose& body_in_map, BodyId id);
    ~BulletRigidBody() override;
    BulletRigidBody(const BulletRigidBody&) = delete;
    BulletRigidBody& operator=(const BulletRigidBody&) = delete;

    void place(const Pose& body_in_map) override;
    void lift(double height_m) override;
    void letSleep(bool allowed) override;
    void wake() override { rigid_->activate(); }
    BodyState state(int link) const override;
    void runSurface(const Vec3& velocity_in_body_m_s) override { surface_ = toBullet(velocity_in_body_m_s); }
    void apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) override;
    void beforeStep(Seconds dt) override;
    void afterStep() override {}
    btVector3 velocityBefore(int link, const btVector3& point) const override;

private:
    btDynamicsWorld& world_;
    BulletShape shape_;
    std::unique_ptr<btRigidBody> rigid_;
    btVector3 velocity_{0.0, 0.0, 0.0}; ///< before the step, like `rate_`
    btVector3 rate_{0.0, 0.0, 0.0};
    btVector3 surface_{0.0, 0.0, 0.0}; ///< velocity of a still body's surface, in its frame
};

} // namespace usar::sim
