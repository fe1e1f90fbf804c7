#include "core/sim/rays/body_index.h"

#include <limits>
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
    const auto buckets = static_cast<std::size_t>(columns_ * rows_);
    starts_.assign(buckets + 1, 0);
    const auto forEachBucket = [&](const BodySphere& sphere, auto use) {
        const Range range = footprint(sphere);
        for (std::ptrdiff_t row = range.first_row; row <= range.last_row; ++row)
            for (std::ptrdiff_t column = range.first_column; column <= range.last_column; ++column)
                use(static_cast<std::size_t>(row * columns_ + column));
    };
    for (const BodySphere& sphere : spheres_)
        forEachBucket(sphere, [&](std::size_t bucket) { ++starts_[bucket + 1]; });
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
        starts_[bucket + 1] += starts_[bucket];
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
    columns_ = rows_ = 0;
    if (spheres_.empty())
        return;
    origin_m_ = low.head<2>();
    minimum_z_m_ = low.z();
    maximum_z_m_ = high.z();
    const Vec2 size_m = (high - low).head<2>();
    bucket_m_ = std::max(smallest_bucket_m, size_m.maxCoeff() / most_buckets_a_side);
    columns_ = static_cast<std::ptrdiff_t>(size_m.x() / bucket_m_) + 1;
    rows_ = static_cast<std::ptrdiff_t>(size_m.y() / bucket_m_) + 1;
}

BodyIndex::Range BodyIndex::bucketsUnder(const Vec2& low_m, const Vec2& high_m) const {
    const auto bucket = [&](double at_m, double origin_m, std::ptrdiff_t count) {
        const double last = static_cast<double>(count - 1);
        return static_cast<std::ptrdiff_t>(std::min(std::max(0.0, (at_m - origin_m) / bucket_m_), last));
    };
    return {bucket(low_m.x(), origin_m_.x(), columns_), bucket(high_m.x(), origin_m_.x(), columns_),
            bucket(low_m.y(), origin_m_.y(), rows_), bucket(high_m.y(), origin_m_.y(), rows_)};
}

BodyIndex::Range BodyIndex::footprint(const BodySphere& sphere) const {
    const Vec2 reach_m = Vec2::Constant(sphere.radius_m + hair_m);
    return bucketsUnder(sphere.center_m.head<2>() - reach_m, sphere.center_m.head<2>() + reach_m);
}

} // namespace usar::sim
