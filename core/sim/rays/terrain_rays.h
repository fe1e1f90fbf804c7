// Rays against a height field: a grid traversal that skips whole tiles below the ray.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/sim/rays/grid_walk.h"
#include "core/sim/rays/ray_bundle.h"
#include "core/sim/rays/ray_shapes.h"
#include "core/sim/world/terrain.h"

namespace usar::sim {

/// Uses height maxima over 16x16 cells (robots-and-worlds.md, section 6: 4 Mray/s against Bullet's 0.2), and finer and
/// coarser ones for bundles. Watertight: the height of the ray above the ground is followed from cell edge to cell
/// edge, so no ray slips between triangles. Built once from a terrain that must outlive it; immutable afterwards.
class TerrainRays {
public:
    explicit TerrainRays(const Terrain& terrain);

    /// Distance to the ground: `maximum_m` on a miss, 0 from below ground. The ground is a solid block: a ray that
    /// enters the extent below its rim hits there. `maximum_m` decides whether a hit counts, not where it is.
    double cast(const Ray& ray, double maximum_m) const { return cast(ray, maximum_m, isOver(ray.origin_m)); }
    /// The same for a ray of which it is known whether it starts over the ground: neighbors start at the same point.
    double cast(const Ray& ray, double maximum_m, bool starts_over) const;
    /// True on or above the ground, and not beyond its rim.
    bool isOver(const Vec3& point_m) const;

    /// The minimum of `cast` over the bundle's rays.
    double castNearest(const RayBundle& bundle, double maximum_m) const;

private:
    /// The highest posts of squares of `cells` x `cells` cells, row-major.
    struct Maxima {
        Maxima(std::ptrdiff_t cells_, std::ptrdiff_t columns_, std::ptrdiff_t rows_)
            : cells(cells_)
            , columns(columns_)
            , rows(rows_)
            , highest_m(static_cast<std::size_t>(columns * rows), -std::numeric_limits<float>::infinity()) {}

        float at(std::ptrdiff_t column, std::ptrdiff_t row) const {
            return highest_m[static_cast<std::size_t>(row * columns + column)];
        }
        float& at(std::ptrdiff_t column, std::ptrdiff_t row) {
            return highest_m[static_cast<std::size_t>(row * columns + column)];
        }

        std::ptrdiff_t cells, columns, rows;
        std::vector<float> highest_m;
    };
    static Maxima finestMaxima(const Terrain& terrain);
    static Maxima coarser(const Maxima& fine);
    /// An upper bound of the ground's height under the box.
    double highestUnder_m(const Eigen::AlignedBox3d& box) const;
    /// Time at which the ray meets the ground of a tile, given its time in the tile, or `no_hit_m`.
    double crossTile(const GridWalk& walk, const GridCell& tile, double enter, double leave) const;

    const Terrain* terrain_;
    std::vector<Maxima> levels_; ///< from 4x4 cells to one square for all, each four times as wide as the one before
};

} // namespace usar::sim
