// Positions of moving bodies, sorted into square buckets, so that a ray tests only those near its path.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/sim/rays/grid_walk.h"

namespace usar::sim {

/// A sphere around a body or one rigid piece of it, map frame.
struct BodySphere {
    Vec3 center_m = Vec3::Zero();
    double radius_m = 0.0;
    std::uint32_t piece = 0; ///< the caller's own number for the piece
};

/// Built again when something has moved and a ray asks. With two hundred robots that takes 20 us, and a ray then tests
/// only those in the few buckets on its path.
class BodyIndex {
public:
    /// Replaces the spheres. Those without a finite center are left out.
    void build(std::vector<BodySphere> spheres);

    /// Calls `visit(sphere, nearest_m)` for every sphere that the ray may meet before `nearest_m`, for some more than
    /// once. `visit` returns the new `nearest_m`; the last one is the result.
    template <class Visit>
    double along(const Ray& ray, double maximum_m, Visit visit) const;

    /// True if `counts(sphere)` holds for a sphere that reaches into the box.
    template <class Counts>
    bool anyIn(const Eigen::AlignedBox3d& box_m, Counts counts) const;

private:
    /// Buckets under a sphere.
    BucketGrid::Range footprint(const BodySphere& sphere) const;
    /// Fits the grid to the spheres.
    void layOut();

    static constexpr std::size_t few_spheres = 8; ///< up to this many spheres, a linear scan is faster than the grid

    BucketGrid grid_;
    /// Lowest and highest points of all spheres, between which alone a ray is followed.
    double minimum_z_m_ = 0.0;
    double maximum_z_m_ = 0.0;
    std::vector<BodySphere> spheres_;
    std::vector<std::uint32_t> starts_; ///< bucket i holds items_[starts_[i]] to items_[starts_[i + 1] - 1]
    std::vector<std::uint32_t> items_;  ///< indices into spheres_
};

template <class Visit>
double BodyIndex::along(const Ray& ray, double maximum_m, Visit visit) const {
    if (spheres_.empty())
        return maximum_m;
    return grid_.along(
        ray, maximum_m, minimum_z_m_, maximum_z_m_, [&](std::size_t bucket, double /*lowest_m*/, double nearest_m) {
            for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i) {
                const BodySphere& sphere = spheres_[items_[i]];
                const Vec3 toward_m = sphere.center_m - ray.origin_m;
                const double closest_m = std::clamp(toward_m.dot(ray.direction), 0.0, nearest_m);
                if ((toward_m - closest_m * ray.direction).squaredNorm() <= sphere.radius_m * sphere.radius_m)
                    nearest_m = visit(sphere, nearest_m);
            }
            return nearest_m;
        });
}

template <class Counts>
bool BodyIndex::anyIn(const Eigen::AlignedBox3d& box_m, Counts counts) const {
    const auto reaches = [&](const BodySphere& sphere) {
        return box_m.squaredExteriorDistance(sphere.center_m) <= sphere.radius_m * sphere.radius_m && counts(sphere);
    };
    if (spheres_.size() <= few_spheres)
        return std::ranges::any_of(spheres_, reaches);
    return grid_.anyIn(grid_.under(box_m.min().head<2>(), box_m.max().head<2>()), [&](std::size_t bucket) {
        return std::any_of(items_.begin() + starts_[bucket], items_.begin() + starts_[bucket + 1],
                           [&](std::uint32_t item) { return reaches(spheres_[item]); });
    });
}

} // namespace usar::sim
