// An articulated body in Bullet, in Featherstone's reduced coordinates. Internal to the physics.
#pragma once

#include <memory>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "core/sim/physics/bullet_body.h"

namespace usar::sim {

/// Bullet limits joint motors by impulse, not by torque, so the limit is set again at each step. A joint's damping is a
/// second motor that pulls toward standstill with no more than the damping torque, so that it never reverses a joint,
/// however light it is.
class BulletMultiBody : public BulletBody {
public:
    /// `world` must outlive it.
    BulletMultiBody(btMultiBodyDynamicsWorld& world, const ArticulatedDescription& description, const Pose& base_in_map,
                    BodyId id);
    ~BulletMultiBody() override;
    BulletMultiBody(const BulletMultiBody&) = delete;
    BulletMultiBody& operator=(const BulletMultiBody&) = delete;

    /// The joints stay where they are.
    void place(const Pose& base_in_map) override;
    void lift(double height_m) override;
    void letSleep(bool allowed) override;
    void wake() override;
    BodyState state(int link) const override;
    JointState joint(std::size_t link) const override;
    /// Wakes the body if this changes the motor.
    void setMotor(std::size_t link, const JointMotor& motor) override;
    void apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) override;
    void beforeStep(Seconds dt) override;
    void afterStep() override { refreshVelocities(); }
    btVector3 velocityBefore(int link, const btVector3& point) const override;

private:
    /// The collider of the base or of a link, with its shape.
    struct Piece {
        explicit Piece(const BodyDescription& description) : shape(description) {}
        BulletShape shape;
        std::unique_ptr<btMultiBodyLinkCollider> collider;
    };
    struct Joint {
        std::unique_ptr<btMultiBodyJointLimitConstraint> limits;
        std::unique_ptr<btMultiBodyJointMotor> damper;
        std::unique_ptr<btMultiBodyJointMotor> motor; ///< exists unless the wanted mode is Off
        double damping = 0.0;                         ///< N m s/rad or N s/m
        JointMotor wanted;
    };

    void addLink(int index, const LinkDescription& description);
    void addPiece(int link, const BodyDescription& description, BodyId id);
    void addConstraints(int index, const LinkDescription& description);
    /// Sets the impulse limits of a joint's motor and damper for the next step.
    void drive(int index, Joint& joint, Seconds dt);
    /// Moves the colliders to where the base and the joints put the links.
    void moveColliders();
    void refreshVelocities();
    const btTransform& transform(int link) const;

    btMultiBodyDynamicsWorld& world_;
    btMultiBody body_;
    std::vector<Piece> parts_; ///< the base first, as in the arrays below
    std::vector<Joint> joints_;
    std::vector<btVector3> velocities_; ///< velocities of origins, map frame, after the last step
    std::vector<btVector3> rates_;      ///< angular velocities, likewise
};

} // namespace usar::sim
