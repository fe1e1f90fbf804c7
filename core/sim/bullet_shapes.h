// The parts of a body as one Bullet shape. Internal to the physics.
#pragma once

#include <memory>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "core/sim/physics.h"

namespace usar::sim {

inline constexpr int ground_group = 1;
inline constexpr int body_group = 2;

/// A compound of the parts, and their owner.
class BulletShape {
public:
    explicit BulletShape(const BodyDescription& description);

    btCompoundShape* compound() const { return compound_.get(); }
    bool empty() const { return parts_.empty(); }
    /// Of a sphere around the body's origin that holds it.
    double radius_m() const { return radius_m_; }

private:
    std::vector<std::unique_ptr<btCollisionShape>> parts_;
    std::unique_ptr<btCompoundShape> compound_;
    double radius_m_ = 0.0;
};

/// Marks a collision object as a part of this body, and gives it the body's friction. What bounces is for the body's
/// kind to say.
void markAsBody(btCollisionObject& object, const BodyDescription& description, BodyId id, int link);

} // namespace usar::sim
