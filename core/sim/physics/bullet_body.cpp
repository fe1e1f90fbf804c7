#include "core/sim/physics/bullet_body.h"

#include <variant>

#include "core/sim/physics/bullet_ground.h"

namespace usar::sim {

namespace {

constexpr double part_margin_m = 0.005;

std::unique_ptr<btCollisionShape> makeShape(const CylinderShape& shape) {
    return std::make_unique<btCylinderShapeZ>(btVector3(shape.radius_m, shape.radius_m, shape.height_m / 2.0));
}
std::unique_ptr<btCollisionShape> makeShape(const CapsuleShape& shape) {
    return std::make_unique<btCapsuleShapeZ>(shape.radius_m, shape.height_m);
}
std::unique_ptr<btCollisionShape> makeShape(const BoxShape& shape) {
    return std::make_unique<btBoxShape>(toBullet(Vec3(shape.size_m / 2.0)));
}
std::unique_ptr<btCollisionShape> makeShape(const SphereShape& shape) {
    return std::make_unique<btSphereShape>(shape.radius_m);
}

// The collision margin of a capsule or sphere is its radius.
bool isRound(const BodyPart& part) {
    return std::holds_alternative<CapsuleShape>(part.shape) || std::holds_alternative<SphereShape>(part.shape);
}

} // namespace

BulletShape::BulletShape(const BodyDescription& description)
    : compound_(std::make_unique<btCompoundShape>(true, static_cast<int>(description.parts.size()))) {
    for (const BodyPart& part : description.parts) {
        auto shape = std::visit([](const auto& one) { return makeShape(one); }, part.shape);
        if (!isRound(part))
            shape->setMargin(part_margin_m);
        compound_->addChildShape(toBullet(part.part_in_body), shape.get());
        parts_.push_back(std::move(shape));
    }
    btVector3 low;
    btVector3 high;
    compound_->getAabb(btTransform::getIdentity(), low, high);
    btVector3 farthest = low.absolute();
    farthest.setMax(high.absolute());
    radius_m_ = farthest.length();
}

void markAsBody(btCollisionObject& object, const BodyDescription& description, BodyId id, int link) {
    object.setFriction(description.friction);
    object.setRollingFriction(description.rolling_friction_m);
    object.setRestitution(0.0);
    object.setUserIndex(static_cast<int>(Surface::Body));
    object.setUserIndex2(static_cast<int>(id.value));
    object.setUserIndex3(link);
    object.setActivationState(DISABLE_DEACTIVATION);
}

} // namespace usar::sim
