#include "core/sim/rays/plant_index.h"

#include <algorithm>
#include <cmath>

#include "core/sim/rays/grid_walk.h"

namespace usar::sim {

namespace {

constexpr double bucket_m = 4.0;
constexpr double slack_m = 0.001;

double reach_m(const Plant& plant) {
    return std::max(plant.trunk_radius_m, plant.crown_radius_m);
}

double top_m(const Plant& plant) {
    const double crown_m = plant.crown == CrownShape::Cone ? plant.crown_height_m : plant.crown_radius_m;
    return plant.base_in_map_m.z() + plant.trunk_height_m + crown_m;
}

/// A spherical crown may hang lower than the foot of its trunk.
double bottom_m(const Plant& plant) {
    const double crown_m = plant.crown == CrownShape::Sphere ? plant.crown_radius_m : 0.0;
    return plant.base_in_map_m.z() + std::min(0.0, plant.trunk_height_m - crown_m);
}

/// False if the ray's line passes the plant's axis at a distance, or if the plant is entirely behind the ray's start.
bool passesNear(const Plant& plant, const Ray& ray) {
    const double x = plant.base_in_map_m.x() - ray.origin_m.x();
    const double y = plant.base_in_map_m.y() - ray.origin_m.y();
    const double dx = ray.direction.x();
    const double dy = ray.direction.y();
    const double reach2 = reach_m(plant) * reach_m(plant);
    const double across = x * dy - y * dx;
    if (across * across > reach2 * (dx * dx + dy * dy))
        return false;
    return x * dx + y * dy > 0.0 || x * x + y * y <= reach2;
}

double hitPlant(const Plant& plant, const Ray& ray) {
    double nearest_m = no_hit_m;
    const Vec3 crown_m = plant.base_in_map_m + Vec3{0.0, 0.0, plant.trunk_height_m};
    if (plant.crown_radius_m > 0.0)
        nearest_m = plant.crown == CrownShape::Sphere
                        ? hitSphere(ray, crown_m, plant.crown_radius_m)
                        : hitCone(ray, crown_m, plant.crown_radius_m, plant.crown_height_m);
    if (plant.trunk_radius_m > 0.0 && plant.trunk_height_m > 0.0)
        nearest_m =
            std::min(nearest_m, hitCylinder(ray, plant.base_in_map_m, plant.trunk_radius_m, plant.trunk_height_m));
    return nearest_m;
}

double nearestOn(const Plant& plant, const RayBundle& bundle, double nearest_m) {
    if (!bundle.mayMeetColumn(plant.base_in_map_m.head<2>(), reach_m(plant), nearest_m))
        return nearest_m;
    for (const Vec3& direction : bundle.directions()) {
        const Ray ray{bundle.origin_m(), direction};
        if (passesNear(plant, ray))
            nearest_m = std::min(nearest_m, hitPlant(plant, ray));
    }
    return nearest_m;
}

std::ptrdiff_t bucketOf(double offset_m) {
    return static_cast<std::ptrdiff_t>(std::floor(offset_m / bucket_m));
}

} // namespace

PlantIndex::PlantIndex(const std::vector<Plant>& plants) {
    if (plants.empty())
        return;
    Vec2 low_m = Vec2::Constant(no_hit_m);
    Vec2 high_m = Vec2::Constant(-no_hit_m);
    minimum_z_m_ = no_hit_m;
    maximum_z_m_ = -no_hit_m;
    for (const Plant& plant : plants) {
        low_m = low_m.cwiseMin(plant.base_in_map_m.head<2>() - Vec2::Constant(reach_m(plant)));
        high_m = high_m.cwiseMax(plant.base_in_map_m.head<2>() + Vec2::Constant(reach_m(plant)));
        minimum_z_m_ = std::min(minimum_z_m_, bottom_m(plant));
        maximum_z_m_ = std::max(maximum_z_m_, top_m(plant));
    }
    origin_m_ = low_m;
    columns_ = bucketOf(high_m.x() - low_m.x()) + 1;
    rows_ = bucketOf(high_m.y() - low_m.y()) + 1;

    const auto buckets = static_cast<std::size_t>(columns_ * rows_);
    std::vector<std::vector<Plant>> sorted(buckets);
    tops_m_.assign(buckets, -std::numeric_limits<float>::infinity());
    for (const Plant& plant : plants) {
        const Range range = footprint(plant);
        for (std::ptrdiff_t row = range.first_row; row <= range.last_row; ++row)
            for (std::ptrdiff_t column = range.first_column; column <= range.last_column; ++column) {
                const std::size_t bucket = bucketAt(column, row);
                sorted[bucket].push_back(plant);
                tops_m_[bucket] = std::max(tops_m_[bucket], std::nextafter(static_cast<float>(top_m(plant)), 1e30f));
            }
    }
    starts_.reserve(buckets + 1);
    for (const std::vector<Plant>& bucket : sorted) {
        starts_.push_back(static_cast<std::uint32_t>(plants_.size()));
        plants_.insert(plants_.end(), bucket.begin(), bucket.end());
    }
    starts_.push_back(static_cast<std::uint32_t>(plants_.size()));
}

PlantIndex::Range PlantIndex::footprint(const Plant& plant) const {
    // Slightly more than the radius, because a ray that touches the very edge may be counted into the next bucket.
    const Vec2 reach = Vec2::Constant(reach_m(plant) + 1e-6);
    return bucketsUnder(plant.base_in_map_m.head<2>() - reach, plant.base_in_map_m.head<2>() + reach);
}

PlantIndex::Range PlantIndex::bucketsUnder(const Vec2& low_m, const Vec2& high_m) const {
    const auto within = [](double offset_m, std::ptrdiff_t count) {
        return std::clamp<std::ptrdiff_t>(bucketOf(offset_m), 0, count - 1);
    };
    return {within(low_m.x() - origin_m_.x(), columns_), within(high_m.x() - origin_m_.x(), columns_),
            within(low_m.y() - origin_m_.y(), rows_), within(high_m.y() - origin_m_.y(), rows_)};
}

std::size_t PlantIndex::bucketAt(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return static_cast<std::size_t>(row * columns_ + column);
}

double PlantIndex::castNearest(const RayBundle& bundle, double maximum_m) const {
    constexpr std::ptrdiff_t most_buckets = 64; // Beyond this, each ray of a wide bundle is better cast on its own.
    const Eigen::AlignedBox3d box = bundle.box(maximum_m);
    const double bottom = box.min().z() - slack_m;
    const double top = box.max().z() + slack_m;
    if (plants_.empty() || bottom > maximum_z_m_ || top < minimum_z_m_)
        return maximum_m;
    double nearest_m = maximum_m;
    const Range range = bucketsUnder(box.min().head<2>(), box.max().head<2>());
    if ((range.last_column - range.first_column + 1) * (range.last_row - range.first_row + 1) > most_buckets) {
        for (const Vec3& direction : bundle.directions())
            nearest_m = cast({bundle.origin_m(), direction}, nearest_m);
        return nearest_m;
    }
    for (std::ptrdiff_t row = range.first_row; row <= range.last_row; ++row)
        for (std::ptrdiff_t column = range.first_column; column <= range.last_column; ++column) {
            const std::size_t bucket = bucketAt(column, row);
            if (static_cast<double>(tops_m_[bucket]) < bottom)
                continue;
            for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i)
                if (bottom_m(plants_[i]) <= top && top_m(plants_[i]) >= bottom)
                    nearest_m = nearestOn(plants_[i], bundle, nearest_m);
        }
    return nearest_m;
}

template <class TakeBucket>
double PlantIndex::walk(const Ray& ray, double maximum_m, TakeBucket takeBucket) const {
    if (plants_.empty())
        return maximum_m;
    GridWalk walk(ray, origin_m_, bucket_m, maximum_m);
    walk.clip(walk.x, 0.0, static_cast<double>(columns_));
    walk.clip(walk.y, 0.0, static_cast<double>(rows_));
    // A ray into the sky is soon above all crowns.
    walk.clip(walk.z, minimum_z_m_ - slack_m, maximum_z_m_ + slack_m);
    if (walk.leave < walk.enter)
        return maximum_m;
    double nearest_m = maximum_m;
    double enter = walk.enter;
    GridCell cell(walk, enter, columns_, rows_, 1);
    while (enter <= std::min(walk.leave, nearest_m) && cell.isWithin(columns_, rows_)) {
        const std::size_t bucket = bucketAt(cell.column, cell.row);
        const double next = std::max(enter, cell.advance(walk));
        if (walk.lowest_m(enter, std::min(next, walk.leave)) <= static_cast<double>(tops_m_[bucket]))
            nearest_m = takeBucket(starts_[bucket], starts_[bucket + 1], nearest_m);
        enter = next;
    }
    return nearest_m;
}

double PlantIndex::cast(const Ray& ray, double maximum_m) const {
    return walk(ray, maximum_m, [&](std::uint32_t first, std::uint32_t last, double nearest_m) {
        for (std::uint32_t i = first; i < last; ++i)
            if (passesNear(plants_[i], ray))
                nearest_m = std::min(nearest_m, hitPlant(plants_[i], ray));
        return nearest_m;
    });
}

double PlantIndex::look(const Ray& ray, double maximum_m, const Plant*& hit) const {
    return walk(ray, maximum_m, [&](std::uint32_t first, std::uint32_t last, double nearest_m) {
        for (std::uint32_t i = first; i < last; ++i) {
            if (!passesNear(plants_[i], ray))
                continue;
            if (const double hit_m = hitPlant(plants_[i], ray); hit_m < nearest_m) {
                nearest_m = hit_m;
                hit = &plants_[i];
            }
        }
        return nearest_m;
    });
}

} // namespace usar::sim
