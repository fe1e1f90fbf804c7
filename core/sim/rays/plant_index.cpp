#include "core/sim/rays/plant_index.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double slack_m = 0.001;
constexpr std::ptrdiff_t most_buckets = 64; ///< each ray of a bundle over more of them is better cast on its own

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

/// Center of a spherical crown, or of the base of a conical one.
Vec3 crownIn_m(const Plant& plant) {
    return plant.base_in_map_m + Vec3{0.0, 0.0, plant.trunk_height_m};
}

double hitCrown(const Plant& plant, const Ray& ray) {
    if (plant.crown_radius_m <= 0.0)
        return no_hit_m;
    const Vec3 crown_m = crownIn_m(plant);
    return plant.crown == CrownShape::Sphere ? hitSphere(ray, crown_m, plant.crown_radius_m)
                                             : hitCone(ray, crown_m, plant.crown_radius_m, plant.crown_height_m);
}

double hitPlant(const Plant& plant, const Ray& ray) {
    double nearest_m = hitCrown(plant, ray);
    if (plant.trunk_radius_m > 0.0 && plant.trunk_height_m > 0.0)
        nearest_m =
            std::min(nearest_m, hitCylinder(ray, plant.base_in_map_m, plant.trunk_radius_m, plant.trunk_height_m));
    return nearest_m;
}

/// `nearest_m`, or less if the ray meets the plant before.
double nearer(const Plant& plant, const Ray& ray, double nearest_m) {
    return passesNear(plant, ray) ? std::min(nearest_m, hitPlant(plant, ray)) : nearest_m;
}

/// Like `nearer`; `hit` becomes the plant if the ray meets it before.
double lookAt(const Plant& plant, const Ray& ray, double nearest_m, const Plant*& hit) {
    const double hit_m = nearer(plant, ray, nearest_m);
    if (hit_m < nearest_m)
        hit = &plant;
    return hit_m;
}

double nearestOn(const Plant& plant, const RayBundle& bundle, double nearest_m) {
    if (!bundle.mayMeetColumn(plant.base_in_map_m.head<2>(), reach_m(plant), nearest_m))
        return nearest_m;
    for (const Vec3& direction : bundle.directions())
        nearest_m = nearer(plant, {bundle.origin_m(), direction}, nearest_m);
    return nearest_m;
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
    grid_.origin_m = low_m;
    grid_.columns = static_cast<std::ptrdiff_t>((high_m.x() - low_m.x()) / grid_.bucket_m) + 1;
    grid_.rows = static_cast<std::ptrdiff_t>((high_m.y() - low_m.y()) / grid_.bucket_m) + 1;

    std::vector<std::vector<Plant>> sorted(grid_.buckets());
    tops_m_.assign(sorted.size(), -std::numeric_limits<float>::infinity());
    for (const Plant& plant : plants) {
        // Slightly more than the radius, because a ray that touches the very edge may be counted into the next bucket.
        const Vec2 reach = Vec2::Constant(reach_m(plant) + 1e-6);
        const Vec2 center_m = plant.base_in_map_m.head<2>();
        grid_.anyIn(grid_.under(center_m - reach, center_m + reach), [&](std::size_t bucket) {
            sorted[bucket].push_back(plant);
            tops_m_[bucket] = std::max(tops_m_[bucket], std::nextafter(static_cast<float>(top_m(plant)), 1e30f));
            return false;
        });
    }
    starts_.reserve(sorted.size() + 1);
    for (const std::vector<Plant>& bucket : sorted) {
        starts_.push_back(static_cast<std::uint32_t>(plants_.size()));
        plants_.insert(plants_.end(), bucket.begin(), bucket.end());
    }
    starts_.push_back(static_cast<std::uint32_t>(plants_.size()));
}

template <class Take>
void PlantIndex::forEachIn(const BucketGrid::Range& range, const Eigen::AlignedBox3d& box, Take take) const {
    const double bottom = box.min().z() - slack_m;
    const double top = box.max().z() + slack_m;
    if (plants_.empty() || bottom > maximum_z_m_ || top < minimum_z_m_)
        return;
    grid_.anyIn(range, [&](std::size_t bucket) {
        if (static_cast<double>(tops_m_[bucket]) >= bottom)
            for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i)
                if (bottom_m(plants_[i]) <= top && top_m(plants_[i]) >= bottom)
                    take(i);
        return false;
    });
}

double PlantIndex::castNearest(const RayBundle& bundle, double maximum_m) const {
    const Eigen::AlignedBox3d box = bundle.box(maximum_m);
    const BucketGrid::Range range = grid_.under(box.min().head<2>(), box.max().head<2>());
    double nearest_m = maximum_m;
    if (range.buckets() > most_buckets) {
        for (const Vec3& direction : bundle.directions())
            nearest_m = cast({bundle.origin_m(), direction}, nearest_m);
        return nearest_m;
    }
    forEachIn(range, box, [&](std::uint32_t i) { nearest_m = nearestOn(plants_[i], bundle, nearest_m); });
    return nearest_m;
}

std::optional<std::vector<std::uint32_t>> PlantIndex::near(const RayBundle& bundle, double length_m) const {
    const Eigen::AlignedBox3d box = bundle.box(length_m);
    const BucketGrid::Range range = grid_.under(box.min().head<2>(), box.max().head<2>());
    if (range.buckets() > most_buckets)
        return std::nullopt;
    std::vector<std::uint32_t> numbers;
    const auto is_copy_of = [&](std::uint32_t i) {
        return [&, i](std::uint32_t other) { return plants_[other] == plants_[i]; };
    };
    forEachIn(range, box, [&](std::uint32_t i) {
        if (bundle.mayMeetColumn(plants_[i].base_in_map_m.head<2>(), reach_m(plants_[i]), length_m) &&
            std::ranges::none_of(numbers, is_copy_of(i)))
            numbers.push_back(i);
    });
    return numbers;
}

template <class TakeBucket>
double PlantIndex::walk(const Ray& ray, double maximum_m, TakeBucket takeBucket) const {
    if (plants_.empty())
        return maximum_m;
    // A ray into the sky is soon above all crowns.
    return grid_.along(ray, maximum_m, minimum_z_m_ - slack_m, maximum_z_m_ + slack_m,
                       [&](std::size_t bucket, double lowest_m, double nearest_m) {
                           return lowest_m <= static_cast<double>(tops_m_[bucket])
                                      ? takeBucket(starts_[bucket], starts_[bucket + 1], nearest_m)
                                      : nearest_m;
                       });
}

double PlantIndex::cast(const Ray& ray, double maximum_m) const {
    return walk(ray, maximum_m, [&](std::uint32_t first, std::uint32_t last, double nearest_m) {
        for (std::uint32_t i = first; i < last; ++i)
            nearest_m = nearer(plants_[i], ray, nearest_m);
        return nearest_m;
    });
}

double PlantIndex::cast(const Ray& ray, double maximum_m, std::span<const std::uint32_t> numbers) const {
    double nearest_m = maximum_m;
    for (const std::uint32_t i : numbers)
        nearest_m = nearer(plants_[i], ray, nearest_m);
    return nearest_m;
}

double PlantIndex::look(const Ray& ray, double maximum_m, const Plant*& hit) const {
    return walk(ray, maximum_m, [&](std::uint32_t first, std::uint32_t last, double nearest_m) {
        for (std::uint32_t i = first; i < last; ++i)
            nearest_m = lookAt(plants_[i], ray, nearest_m, hit);
        return nearest_m;
    });
}

double PlantIndex::look(const Ray& ray, double maximum_m, std::span<const std::uint32_t> numbers,
                        const Plant*& hit) const {
    double nearest_m = maximum_m;
    for (const std::uint32_t i : numbers)
        nearest_m = lookAt(plants_[i], ray, nearest_m, hit);
    return nearest_m;
}

bool isCrown(const Plant& plant, const Ray& ray, double distance_m) {
    return hitCrown(plant, ray) <= distance_m + 1e-6;
}

Vec3 normalOfPlant(const Plant& plant, const Ray& ray, double distance_m) {
    if (distance_m <= 0.0)
        return -ray.direction;
    const Vec3 point_m = ray.origin_m + distance_m * ray.direction;
    if (!isCrown(plant, ray, distance_m))
        return normalOfCylinder(point_m, plant.base_in_map_m, plant.trunk_height_m);
    const Vec3 from_crown = point_m - crownIn_m(plant);
    return plant.crown == CrownShape::Sphere ? from_crown.normalized()
                                             : normalOfCone(from_crown, plant.crown_radius_m, plant.crown_height_m);
}

} // namespace usar::sim
