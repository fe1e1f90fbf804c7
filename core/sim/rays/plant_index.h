// Trunks and crowns sorted into square buckets, so that a ray tests only plants near its path.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/sim/rays/grid_walk.h"
#include "core/sim/rays/ray_bundle.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// The buckets are 4 m wide (robots-and-worlds.md, section 6). A plant is copied into every bucket that its footprint
/// touches, so that a bucket is one run of memory. Independent of the plants it was built from; immutable afterwards.
class PlantIndex {
public:
    explicit PlantIndex(const std::vector<Plant>& plants);

    /// Distance to the first trunk or crown; `maximum_m` on a miss.
    double cast(const Ray& ray, double maximum_m) const;
    /// Like `cast`; `first` becomes the plant that is hit, which belongs to the index, and is unchanged on a miss.
    double look(const Ray& ray, double maximum_m, const Plant*& first) const;
    /// The minimum of `cast` over the bundle's rays.
    double castNearest(const RayBundle& bundle, double maximum_m) const;
    /// The numbers of the plants, in this index, that a ray of the bundle may meet within this length; nullopt if they
    /// are spread so far that each ray finds its own sooner.
    std::optional<std::vector<std::uint32_t>> near(const RayBundle& bundle, double length_m) const;
    /// Like `cast` and `look`, for a ray that can meet only these plants.
    double cast(const Ray& ray, double maximum_m, std::span<const std::uint32_t> numbers) const;
    double look(const Ray& ray, double maximum_m, std::span<const std::uint32_t> numbers, const Plant*& first) const;
    /// Height of the highest plant's top; 0 if there are no plants.
    double maximum_z_m() const { return maximum_z_m_; }

private:
    /// `takeBucket(first, last, nearest_m)` returns how far the ray gets among these plants.
    template <class TakeBucket>
    double walk(const Ray& ray, double maximum_m, TakeBucket takeBucket) const;
    /// Calls `take(number)` for the plants in these buckets whose heights meet the box's.
    template <class Take>
    void forEachIn(const BucketGrid::Range& range, const Eigen::AlignedBox3d& box, Take take) const;

    BucketGrid grid_{.bucket_m = 4.0};
    double minimum_z_m_ = 0.0;
    double maximum_z_m_ = 0.0;
    std::vector<std::uint32_t> starts_; ///< bucket i holds plants_[starts_[i]] to plants_[starts_[i + 1] - 1]
    std::vector<float> tops_m_;         ///< highest point of a bucket's plants
    std::vector<Plant> plants_;
};

/// True if at this distance the ray hits the crown, not the trunk.
bool isCrown(const Plant& plant, const Ray& ray, double distance_m);
/// Normal of crown or trunk, whichever the ray has hit at this distance: a unit vector out of the plant, or back along
/// the ray if it starts inside (`distance_m` is 0).
Vec3 normalOfPlant(const Plant& plant, const Ray& ray, double distance_m);

} // namespace usar::sim
