// Positions of moving bodies, sorted into square buckets, so that a ray tests only those near its path.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/sim/rays/grid_walk.h"

namespace usar::sim {

/// A sphere around one rigid piece of a body, map frame.
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
    /// Columns and rows of buckets, both ends included.
    struct Range {
        std::ptrdiff_t first_column, last_column, first_row, last_row;
    };
    Range bucketsUnder(const Vec2& low_m, const Vec2& high_m) const;
    /// Buckets under a sphere.
    Range footprint(const BodySphere& sphere) const;
    /// Fits the grid to the spheres.
    void layOut();

    static constexpr std::size_t few_spheres = 8; ///< up to this many spheres, a linear scan is faster than the grid

    Vec2 origin_m_ = Vec2::Zero();
    double bucket_m_ = 1.0; ///< width of a bucket
    std::ptrdiff_t columns_ = 0;
    std::ptrdiff_t rows_ = 0;
    double minimum_z_m_ = 0.0;
    double maximum_z_m_ = 0.0;
    std::vector<BodySphere> spheres_;
    std::vector<std::uint32_t> starts_; ///< bucket i holds items_[starts_[i]] to items_[starts_[i + 1] - 1]
    std::vector<std::uint32_t> items_;  ///< indices into spheres_
};

template <class Visit>
double BodyIndex::along(const Ray& ray, double maximum_m, Visit visit) const {
    double nearest_m = maximum_m;
    if (spheres_.empty())
        return nearest_m;
    GridWalk walk(ray, origin_m_, bucket_m_, maximum_m);
    walk.clip(walk.x, 0.0, static_cast<double>(columns_));
    walk.clip(walk.y, 0.0, static_cast<double>(rows_));
    walk.clip(walk.z, minimum_z_m_, maximum_z_m_);
    if (walk.leave < walk.enter)
        return nearest_m;
    double enter = walk.enter;
    GridCell cell(walk, enter, columns_, rows_, 1);
    while (enter <= std::min(walk.leave, nearest_m) && cell.isWithin(columns_, rows_)) {
        const auto bucket = static_cast<std::size_t>(cell.row * columns_ + cell.column);
        for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i) {
            const BodySphere& sphere = spheres_[items_[i]];
            const Vec3 toward_m = sphere.center_m - ray.origin_m;
            const double closest_m = std::clamp(toward_m.dot(ray.direction), 0.0, nearest_m);
            if ((toward_m - closest_m * ray.direction).squaredNorm() <= sphere.radius_m * sphere.radius_m)
                nearest_m = visit(sphere, nearest_m);
        }
        enter = std::max(enter, cell.advance(walk));
    }
    return nearest_m;
}

template <class Counts>
bool BodyIndex::anyIn(const Eigen::AlignedBox3d& box_m, Counts counts) const {
    const auto reaches = [&](const BodySphere& sphere) {
        return box_m.squaredExteriorDistance(sphere.center_m) <= sphere.radius_m * sphere.radius_m && counts(sphere);
    };
    if (spheres_.size() <= few_spheres)
        return std::any_of(spheres_.begin(), spheres_.end(), reaches);
    const Range range = bucketsUnder(box_m.min().head<2>(), box_m.max().head<2>());
    for (std::ptrdiff_t row = range.first_row; row <= range.last_row; ++row)
        for (std::ptrdiff_t column = range.first_column; column <= range.last_column; ++column) {
            const auto bucket = static_cast<std::size_t>(row * columns_ + column);
            for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i)
                if (reaches(spheres_[items_[i]]))
                    return true;
        }
    return false;
}

} // namespace usar::sim
