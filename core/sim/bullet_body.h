// A movable body inside Bullet: what rigid bodies and bodies of several links have in common. Internal to the physics.
#pragma once

#include <span>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "core/sim/physics.h"

namespace usar::sim {

inline constexpr double sleepy_m_s = 0.02;
inline constexpr double sleepy_rad_s = 0.02;

/// One rigid piece of a body, as collisions and rays see it.
struct BulletPiece {
    btCollisionObject* object = nullptr;
    double radius_m = 0.0; ///< of a sphere around its origin that holds it
};

/// Adds itself to the world when made and leaves it when it goes. Link -1 is the base.
class BulletBody {
public:
    virtual ~BulletBody() = default;

    virtual void place(const Pose& base_in_map) = 0;
    /// Upward, with all that hangs on it; what falls stops.
    virtual void lift(double height_m) = 0;
    virtual void letSleep(bool allowed) = 0;
    /// What it leaned on may be gone.
    virtual void wake() = 0;
    virtual BodyState state(int link) const = 0;
    virtual JointState joint(std::size_t /*link*/) const { return {}; }
    virtual void setMotor(std::size_t /*link*/, const JointMotor& /*motor*/) {}
    virtual void runSurface(const Vec3& /*velocity_in_body_m_s*/) {}
    virtual void apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) = 0;
    virtual void beforeStep(Seconds dt) = 0;
    virtual void afterStep() = 0;
    /// Of a point of a link, before the step.
    virtual btVector3 velocityBefore(int link, const btVector3& point) const = 0;

    std::span<const BulletPiece> pieces() const { return pieces_; }
    btVector3 position() const { return pieces_.front().object->getWorldTransform().getOrigin(); }

    std::vector<Contact> contacts; ///< of the last step
    bool placed = false;           ///< since the last step: somebody carries it, and knows where to
    double restitution = 0.0;      ///< what this program makes bounce itself, see BulletPhysics::bounce

protected:
    std::vector<BulletPiece> pieces_; ///< the base first
};

} // namespace usar::sim
