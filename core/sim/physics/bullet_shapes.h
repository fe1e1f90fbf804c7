// All parts of a body as one Bullet shape. Internal to the physics.
#pragma once

#include <memory>
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

} // namespace usar::sim
