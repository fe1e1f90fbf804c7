// A movable body in Bullet: the common interface of rigid and articulated bodies. Internal to the physics.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "core/sim/physics/physics.h"

namespace usar::sim {

/// Collision filter groups: the ground meets bodies only.
inline constexpr int ground_group = 1;
inline constexpr int body_group = 2;

/// A compound of a body's parts; owns them all.
class BulletShape {
public:
    explicit BulletShape(const BodyDescription& description);

    btCompoundShape* compound() const { return compound_.get(); }
    /// True if the body has no parts, so that it touches nothing.
    bool empty() const { return parts_.empty(); }
    /// Radius of the sphere around the body's origin that represents it in the index of bodies for rays.
    double radius_m() const { return radius_m_; }

private:
    std::vector<std::unique_ptr<btCollisionShape>> parts_;
    std::unique_ptr<btCompoundShape> compound_;
    double radius_m_ = 0.0;
};

/// Marks a collision object as part of this body, gives it the body's friction and no restitution. A body that Bullet
/// itself shall bounce sets its restitution afterwards.
void markAsBody(btCollisionObject& object, const BodyDescription& description, BodyId id, int link);

/// Below these speeds a body counts as at rest and may fall asleep.
inline constexpr double sleepy_m_s = 0.02;
inline constexpr double sleepy_rad_s = 0.02;

/// One rigid piece of a body, as collisions and rays see it.
struct BulletPiece {
    btCollisionObject* object = nullptr;
    double radius_m = 0.0; ///< radius of a sphere around its origin, see BulletShape
};

/// The space in which a body is known to touch nothing; see FreeFlight.
struct FreeSpace {
    bool known = false;
    btVector3 center{0.0, 0.0, 0.0};
    double travel_m = 0.0; ///< how far from the center it may fly
    int steps_to_wait = 0; ///< until it is worth looking around again
};

/// Adds itself to the dynamics world when constructed and removes itself when destroyed. Link -1 is the base.
class BulletBody {
public:
    virtual ~BulletBody() = default;

    /// Moves the body, at rest. The pose is that of the base's center of mass.
    virtual void place(const Pose& base_in_map) = 0;
    /// Moves the body up, with all its links, and cancels its downward velocity.
    virtual void lift(double height_m) = 0;
    /// Allows or forbids falling asleep, and wakes the body.
    virtual void letSleep(bool allowed) = 0;
    /// Wakes the body because what it leaned on may be gone.
    virtual void wake() = 0;
    /// The body in Bullet if it is rigid, moves and never sleeps, as that of a robot in the air; otherwise null.
    virtual btRigidBody* flying() { return nullptr; }
    bool asleep() const { return pieces_.front().object->getActivationState() == ISLAND_SLEEPING; }
    virtual BodyState state(int link) const = 0;
    /// Rigid bodies have no joints and ignore motors; articulated ones have no running surface.
    virtual JointState joint(std::size_t /*link*/) const { return {}; }
    virtual void setMotor(std::size_t /*link*/, const JointMotor& /*motor*/) {}
    virtual void runSurface(const Vec3& /*velocity_in_body_m_s*/) {}
    /// Acts at the base's center of mass during the next step; adds up.
    virtual void apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) = 0;
    /// Called right before and right after each step of the dynamics world.
    virtual void beforeStep(Seconds /*dt*/) {}
    virtual void afterStep() = 0;
    /// Velocity that a point of a link had before the step; point and velocity in the map frame.
    virtual btVector3 velocityBefore(int link, const btVector3& point) const = 0;

    std::span<const BulletPiece> pieces() const { return pieces_; }
    /// Origin of the base in the map frame.
    btVector3 position() const { return pieces_.front().object->getWorldTransform().getOrigin(); }

    std::vector<Contact> contacts; ///< contacts of the last step
    bool placed = false;           ///< placed since the last step, so it is where its caller wants it
    FreeSpace free_space;
    double restitution = 0.0; ///< restitution that BulletPhysics::bounce applies instead of Bullet

protected:
    std::vector<BulletPiece> pieces_; ///< base first
};

} // namespace usar::sim
