// Ray casting against a world's fixed parts: the height field by DDA over tile maxima; trunks, crowns and boxes
// analytically.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/rays/ray_bundle.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// The parts of a world that a ray can meet.
enum class Met { Nothing, Ground, Trunk, Crown, Box };

/// The first thing that a ray meets.
struct RayHit {
    double distance_m = 0.0;
    Met met = Met::Nothing;
    /// Unit vector out of the surface; on the ground that of a smooth surface through the posts.
    Vec3 normal_in_map = Vec3::UnitZ();
    Vec3 thing_in_map_m = Vec3::Zero(); ///< the base of a plant or the center of a box; zero otherwise
};

/// The things that rays from one point may meet. Boxes have their numbers in the world, and plants those in the caster;
/// if `plants` is absent, each ray looks for its own.
struct NearThings {
    std::vector<std::uint32_t> boxes{};
    std::optional<std::vector<std::uint32_t>> plants{};
    bool over_ground = false; ///< known to start there
};

/// Double precision, map frame. About 4 million rays a second for the belly scanner on one core; tests compare it ray
/// by ray with the physics engine (method and pitfalls: robots-and-worlds.md, section 6). Built once from a world that
/// must outlive it. Immutable afterwards, so threads may share it.
class RayCaster {
public:
    explicit RayCaster(const World& world);
    ~RayCaster();

    /// Distance to the first hit; `maximum_m` on a miss. `direction` is a unit vector. Water is not seen. A ray that
    /// starts inside a solid or below ground measures 0.
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;
    /// The shortest distance of several rays, which is what a sonar hears. Bit for bit the minimum of `cast` over all
    /// rays, but faster, because what none of them can meet is ruled out at once.
    double castNearest(const RayBundle& bundle, double maximum_m) const;
    /// Like `cast`, but also tells what was hit and how its surface lies, for cameras; somewhat slower. On a miss,
    /// `met` is Nothing at `maximum_m`.
    RayHit look(const Vec3& origin_m, const Vec3& direction, double maximum_m) const;
    /// The things that a ray of the bundle may meet within this length.
    NearThings thingsNear(const RayBundle& bundle, double length_m) const;
    /// Like `cast` and `look`, for a ray that can meet only these things: many rays of a sensor have few things before
    /// them.
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m, const NearThings& things) const;
    RayHit look(const Vec3& origin_m, const Vec3& direction, double maximum_m, const NearThings& things) const;
    /// True if a sonar's sound comes back from what a ray of this direction has hit. A surface that is even for the
    /// wave reflects it away like a mirror if it is met flatly; a rough one scatters it, and so do plants. By
    /// Rayleigh's criterion a surface is even if its unevenness is below wavelength / (8 cos(angle of incidence)). The
    /// wave of a ranging sonar (49.4 kHz: Polaroid 6500 ranging module, data sheet) is 6.9 mm long. Floors and boxes
    /// are uneven by 1.7 mm, so they answer up to 60 degrees from their normal; ground also by what its posts depart
    /// from a plane.
    bool sendsEcho(const Vec3& origin_m, const Vec3& direction, const RayHit& hit) const;
    /// True if a box covers all the ground, as a room's ceiling does.
    bool roofed() const;
    /// True if there is such a box and nothing is above this point, which then is on the box or beside it.
    bool onRoof(const Vec3& point_m) const;
    /// Height of the first thing that a ray from straight above meets: the true surface (ground, crown or roof) at a
    /// point. A box that covers all the ground, such as the ceiling of a closed room, is ignored; the result is the
    /// surface below it.
    double surface_m(const Vec2& point_m) const;
    /// Height of the ground, or of the box on it, straight below a point; plants do not count. Where nothing is below,
    /// that of the lowest thing in the world.
    double floorBelow_m(const Vec3& point_m) const;

private:
    struct Index;
    const World* world_;
    std::unique_ptr<const Index> index_;
};

/// Immutable once made, so threads may share it. Cannot be moved, because the caster points to the world.
struct StillWorld {
    explicit StillWorld(World still) : world(std::move(still)), caster(world) {}
    StillWorld(const StillWorld&) = delete;
    StillWorld& operator=(const StillWorld&) = delete;

    World world;
    RayCaster caster;
};

} // namespace usar::sim
