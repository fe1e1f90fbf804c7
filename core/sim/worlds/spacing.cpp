#include "core/sim/worlds/spacing.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double bucket_m = 4.0;

} // namespace

Spacing::Spacing(double half_m)
    : half_m_(half_m)
    , side_(static_cast<std::ptrdiff_t>(std::ceil(2.0 * half_m / bucket_m)))
    , buckets_(static_cast<std::size_t>(side_ * side_)) {}

std::ptrdiff_t Spacing::bucketOf(double coordinate_m) const {
    const double bucket = std::floor((coordinate_m + half_m_) / bucket_m);
    return std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(bucket), 0, side_ - 1);
}

void Spacing::add(const Vec2& point_m) {
    buckets_[static_cast<std::size_t>(bucketOf(point_m.y()) * side_ + bucketOf(point_m.x()))].push_back(point_m);
}

bool Spacing::isClear(const Vec2& point_m, double distance_m) const {
    for (std::ptrdiff_t row = bucketOf(point_m.y() - distance_m); row <= bucketOf(point_m.y() + distance_m); ++row)
        for (std::ptrdiff_t column = bucketOf(point_m.x() - distance_m); column <= bucketOf(point_m.x() + distance_m);
             ++column)
            for (const Vec2& other_m : buckets_[static_cast<std::size_t>(row * side_ + column)])
                if ((other_m - point_m).norm() < distance_m)
                    return false;
    return true;
}

} // namespace usar::sim
