// Second opinions for our ray caster: the physics engine's own ray test over the same world, and a plain loop over all
// triangles of a terrain.
#pragma once

#include <memory>

#include "core/sim/world/world.h"

namespace usar::doubles {

/// Terrain and boxes as Bullet knows them, trunks as capped cylinders, round crowns as spheres. Cones are left out:
/// Bullet gives them a margin of centimeters (robots-and-worlds.md, section 6). The world must outlive it.
class BulletRays {
public:
    explicit BulletRays(const sim::World& world);
    ~BulletRays();
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

/// Distance to the first triangle that the ray meets, from either side; 1e9 on a miss.
double tryEveryTriangle(const sim::Terrain& terrain, const Vec3& origin_m, const Vec3& direction);

} // namespace usar::doubles
