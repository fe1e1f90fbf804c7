// Rays against a height field: grid traversal that steps over whole tiles which lie below the ray.
#pragma once

#include <cstddef>
#include <vector>

#include "core/sim/grid_walk.h"
#include "core/sim/ray_shapes.h"
#include "core/sim/terrain.h"

namespace usar::sim {

/// One level of maxima over 16x16 cells (robots-and-worlds, section 6: 4 Mray/s against Bullet's 0.2). Watertight: the
/// height of the ray above the ground is followed from cell edge to cell edge, so no ray slips between triangles.
/// Built once from a terrain that must outlive it; const afterwards.
class TerrainRays {
public:
    explicit TerrainRays(const Terrain& terrain);

    /// Distance to the ground, `maximum_m` on a miss, 0 from below ground. The ground is a solid block: a ray that
    /// enters the extent below its rim hits there.
    double cast(const Ray& ray, double maximum_m) const;

    /// No ground within `radius_m` of a point. Looks at whole tiles: what is clear may be said to be not.
    bool isClear(const Vec3& center_m, double radius_m) const;

private:
    double crossTile(const GridWalk& walk, const GridCell& tile, double enter, double leave) const;

    const Terrain* terrain_;
    std::ptrdiff_t tile_columns_ = 0;
    std::ptrdiff_t tile_rows_ = 0;
    std::vector<float> tile_maxima_m_;
};

} // namespace usar::sim
