// Rays against a world's still parts: height field by DDA over tile maxima, trunks, crowns and boxes analytically.
#pragma once

#include <memory>

#include "core/base/geometry.h"
#include "core/sim/ray_bundle.h"
#include "core/sim/world.h"

namespace usar::sim {

enum class Met { Nothing, Ground, Trunk, Crown, Box };

/// What a ray met first.
struct RayHit {
    double distance_m = 0.0;
    Met met = Met::Nothing;
    Vec3 normal_in_map = Vec3::UnitZ(); ///< out of the surface; on the ground that of a smooth one through the posts
    Vec3 thing_in_map_m = Vec3::Zero(); ///< where a plant stands, or a box's center
};

/// Double precision, map frame. Some 4 million rays a second for the belly scanner on one core; compared ray by ray
/// with the physics engine in tests (method and pitfalls: robots-and-worlds, section 6). Built once from a world that
/// must outlive it; const and free of state afterwards, so threads may share it.
class RayCaster {
public:
    explicit RayCaster(const World& world);
    ~RayCaster();

    /// Distance to the first thing hit, `maximum_m` on a miss. `direction` is a unit vector. Water is not seen. A ray
    /// that starts inside something solid or below ground measures 0.
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;
    /// The shortest of several: what a sonar hears. Bit for bit the least of what `cast` answers for each, and sooner:
    /// what none of them can meet is told at once.
    double castNearest(const RayBundle& bundle, double maximum_m) const;
    /// The same for eyes, some dearer: what it is and how it lies. Nothing at `maximum_m` on a miss.
    RayHit look(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;
    /// Whether a box covers all the ground, as a room's ceiling does.
    bool roofed() const;
    /// What a ray from straight above meets first: the true surface (ground, crown or roof) at a point. Under a box
    /// that covers all the ground, the ceiling of a closed room, it is what lies below the ceiling.
    double surface_m(const Vec2& point_m) const;

private:
    struct Index;
    const World* world_;
    std::unique_ptr<const Index> index_;
};

} // namespace usar::sim
