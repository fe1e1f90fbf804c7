#include "core/sim/rays/body_index.h"

#include <limits>
#include <numeric>
#include <utility>

namespace usar::sim {

namespace {

constexpr double smallest_bucket_m = 4.0;
constexpr double most_buckets_a_side = 128.0;
constexpr double hair_m = 1e-6; // A ray that touches the very edge may be counted into the next bucket.

} // namespace

void BodyIndex::build(std::vector<BodySphere> spheres) {
    spheres_ = std::move(spheres);
    std::erase_if(spheres_, [](const BodySphere& one) { return !one.center_m.allFinite(); });
    layOut();
    starts_.assign(grid_.buckets() + 1, 0);
    const auto forEachBucket = [&](const BodySphere& sphere, auto use) {
        grid_.anyIn(footprint(sphere), [&](std::size_t bucket) {
            use(bucket);
            return false;
        });
    };
    for (const BodySphere& sphere : spheres_)
        forEachBucket(sphere, [&](std::size_t bucket) { ++starts_[bucket + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    items_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < spheres_.size(); ++i)
        forEachBucket(spheres_[i], [&](std::size_t bucket) { items_[next[bucket]++] = static_cast<std::uint32_t>(i); });
}

void BodyIndex::layOut() {
    constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 low = Vec3::Constant(far);
    Vec3 high = Vec3::Constant(-far);
    for (const BodySphere& sphere : spheres_) {
        const double reach_m = sphere.radius_m + hair_m;
        low = low.cwiseMin((sphere.center_m.array() - reach_m).matrix());
        high = high.cwiseMax((sphere.center_m.array() + reach_m).matrix());
    }
    grid_.columns = grid_.rows = 0;
    if (spheres_.empty())
        return;
    grid_.origin_m = low.head<2>();
    minimum_z_m_ = low.z();
    maximum_z_m_ = high.z();
    const Vec2 size_m = (high - low).head<2>();
    grid_.bucket_m = std::max(smallest_bucket_m, size_m.maxCoeff() / most_buckets_a_side);
    grid_.columns = static_cast<std::ptrdiff_t>(size_m.x() / grid_.bucket_m) + 1;
    grid_.rows = static_cast<std::ptrdiff_t>(size_m.y() / grid_.bucket_m) + 1;
}

BucketGrid::Range BodyIndex::footprint(const BodySphere& sphere) const {
    const Vec2 reach_m = Vec2::Constant(sphere.radius_m + hair_m);
    return grid_.under(sphere.center_m.head<2>() - reach_m, sphere.center_m.head<2>() + reach_m);
}

} // namespace usar::sim
