// The physics engine's own ray test over the same world: the second opinion for our caster.
#pragma once

#include <memory>

#include "core/sim/world/world.h"

namespace usar::doubles {

/// Terrain and boxes as Bullet knows them, trunks as capped cylinders, round crowns as spheres. Cones are left out:
/// Bullet gives them a margin of centimetres (robots-and-worlds.md, section 6). The world must outlive it.
class BulletRays {
public:
    explicit BulletRays(const sim::World& world);
    ~BulletRays();
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

} // namespace usar::doubles
