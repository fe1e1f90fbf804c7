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
#include "core/sim/physics/link_solver.h"

namespace usar::sim {

/// Bullet limits joint motors by impulse, not by torque, so the limit is set again at each step. A joint's damping is a
/// second motor that pulls toward standstill with no more than the damping torque, so that it never reverses a joint,
/// however light it is.
class BulletMultiBody : public BulletBody, public JointedBody {
public:
    /// `world` must outlive it.
    BulletMultiBody(btMultiBodyDynamicsWorld& world, const ArticulatedDescription& description, const Pose& base_in_map,
                    BodyId id);
    ~BulletMultiBody() override;
    BulletMultiBody(const BulletMultiBody&) = delete;
    BulletMultiBody& operator=(const BulletMultiBody&) = delete;

    /// The joints stay where they are.
    void place(const Pose& base_in_map) override;
    /// Moves the base by `height_m` upward; takes away downward speed but keeps upward speed.
    void lift(double height_m) override;
    /// Wakes the body in any case; without permission it never sleeps again.
    void letSleep(bool allowed) override;
    /// Has no effect on a body that may not sleep, because it is awake.
    void wake() override;
    /// State of a link, or of the base for -1; map frame, velocities after the last step.
    BodyState state(int link) const override;
    /// Position in rad or m and velocity in rad/s or m/s of the joint that carries this link.
    JointState joint(std::size_t link) const override;
    /// Wakes the body if this changes the motor.
    void setMotor(std::size_t link, const JointMotor& motor) override;
    /// Acts on the base alone; the joints pass it on to the links.
    void apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) override;
    bool onWheels() const override { return on_wheels_; }
    std::span<const JointRow> jointRows(double dt_s) override;
    bool movesMass(int link) const override { return joints_[static_cast<std::size_t>(link)].moves_mass; }
    KeptInverse& keptInverse() override { return kept_inverse_; }
    std::span<btMultiBodyConstraint* const> ownConstraints(double dt_s) override;
    void afterStep() override { refreshVelocities(); }
    /// Velocity in m/s, before the step, of the link's point that is at `point` in the map frame.
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
        double lower = 1.0;                           ///< rad or m; above `upper` if there are no limits
        double upper = -1.0;
        bool moves_mass = true; ///< see JointedBody
        JointMotor wanted;
        double motor_n_s = 0.0; ///< impulses of the last step, or N m s
        double damper_n_s = 0.0;
        double limit_n_s = 0.0;
    };

    /// Adds a link on a revolute or prismatic joint; its parent must have been added before.
    void addLink(int index, const LinkDescription& description);
    /// Adds a collider even for a link without a shape, because Bullet finds the joint's motor and limits through it.
    void addPiece(int link, const BodyDescription& description, BodyId id);
    /// Adds limits if the lower one is not above the upper one, and a damper if the joint has damping.
    void addConstraints(int index, const LinkDescription& description);
    /// The speed that a joint's motor aims at in a step from this position.
    static double wantedSpeed(const Joint& joint, double position, double dt_s);
    /// Sets the impulse limits of a joint's motor and damper for the next step.
    void drive(int index, Joint& joint, Seconds dt);
    /// Moves the colliders to where the base and the joints put the links.
    void moveColliders();
    /// Reads all velocities from Bullet and turns them into the map frame.
    void refreshVelocities();
    const btTransform& transform(int link) const;

    btMultiBodyDynamicsWorld& world_;
    btMultiBody body_;
    std::vector<Piece> parts_; ///< the base first, as in the arrays below
    std::vector<Joint> joints_;
    std::vector<JointRow> rows_; ///< see jointRows
    KeptInverse kept_inverse_;
    std::vector<btMultiBodyConstraint*> own_constraints_;
    bool on_wheels_ = false;
    std::vector<btVector3> velocities_; ///< velocities of origins, map frame, after the last step
    std::vector<btVector3> rates_;      ///< angular velocities, likewise
};

} // namespace usar::sim
