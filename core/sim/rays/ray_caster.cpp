#include "core/sim/rays/ray_caster.h"

#include <algorithm>
#include <numeric>

#include "core/sim/rays/plant_index.h"
#include "core/sim/rays/terrain_rays.h"

namespace usar::sim {

namespace {

constexpr double under_ceiling_m = 1e-6;
constexpr double sonar_wave_m = 343.0 / 49'400.0;
constexpr double made_by_hand_m = sonar_wave_m / 4.0; ///< unevenness that answers up to 60 degrees

struct PlacedBox {
    Vec3 center_m;
    Vec3 half_size_m;
    Eigen::Matrix3d box_in_map;
    double radius_m;
};

/// `nearest_m`, or less if the ray meets the box before. Most boxes are ruled out by the sphere around them.
double nearer(const PlacedBox& box, const Ray& ray, double nearest_m) {
    const Vec3 to_center = box.center_m - ray.origin_m;
    const double along = to_center.dot(ray.direction);
    if (along < -box.radius_m || along > nearest_m + box.radius_m ||
        to_center.squaredNorm() - along * along > box.radius_m * box.radius_m + 1e-9)
        return nearest_m;
    return std::min(nearest_m, hitBox(ray, box.center_m, box.box_in_map, box.half_size_m));
}

/// True if the box is level and covers all the ground, as ceilings do.
bool covers(const PlacedBox& box, const Rectangle& ground) {
    if (ground.empty() || !box.box_in_map.isIdentity(1e-9))
        return false;
    const Vec2 center_m = box.center_m.head<2>();
    const Vec2 half_m = box.half_size_m.head<2>() + Vec2::Constant(1e-9);
    return Rectangle{center_m - half_m, center_m + half_m}.contains(ground);
}

/// Normal of a smooth surface through the posts, so that the triangles do not show.
Vec3 normalOfGround(const Terrain& terrain, const Vec2& point_m) {
    const double step_m = terrain.step_m();
    const auto rise = [&](const Vec2& way) {
        return (terrain.height_m(point_m + way) - terrain.height_m(point_m - way)) / (2.0 * step_m);
    };
    return Vec3{-rise({step_m, 0.0}), -rise({0.0, step_m}), 1.0}.normalized();
}

/// How far the ground bends away from a plane within one step of the height field.
double unevenness_m(const Terrain& terrain, const Vec2& point_m) {
    const double step_m = terrain.step_m();
    const double here_m = terrain.height_m(point_m);
    const auto bend_m = [&](const Vec2& way) {
        return std::abs((terrain.height_m(point_m + way) + terrain.height_m(point_m - way)) / 2.0 - here_m);
    };
    return std::max(bend_m({step_m, 0.0}), bend_m({0.0, step_m}));
}

} // namespace

struct RayCaster::Index {
    explicit Index(const World& world) : plants(world.plants), ground(world.terrain) {
        for (const Box& box : world.boxes) {
            const Vec3 half_size_m = box.size_m / 2.0;
            boxes.push_back({box.center_in_map.position_m, half_size_m, box.center_in_map.rotation().toRotationMatrix(),
                             half_size_m.norm()});
        }
        all.boxes.resize(boxes.size());
        std::iota(all.boxes.begin(), all.boxes.end(), 0u);
        findTopAndBottom(world);
    }

    void findTopAndBottom(const World& world) {
        top_m = world.terrain.maximum_m();
        bottom_m = world.terrain.minimum_m();
        if (!world.plants.empty())
            top_m = std::max(top_m, plants.maximum_z_m());
        for (const PlacedBox& box : boxes) {
            top_m = std::max(top_m, box.center_m.z() + box.radius_m);
            bottom_m = std::min(bottom_m, box.center_m.z() - box.radius_m);
        }
        top_m += 1.0;
        for (const PlacedBox& box : boxes) {
            const double underside_m = box.center_m.z() - box.half_size_m.z();
            if (!covers(box, world.terrain.extent()) || underside_m <= static_cast<double>(world.terrain.maximum_m()))
                continue;
            top_m = std::min(top_m, underside_m - under_ceiling_m);
            roofed = true;
        }
    }

    double castAtGround(const Ray& ray, double maximum_m, const NearThings& near) const {
        return near.over_ground ? ground.cast(ray, maximum_m, true) : ground.cast(ray, maximum_m);
    }

    double castAtThings(const Ray& ray, double maximum_m, const NearThings& near) const {
        double nearest_m = near.plants ? plants.cast(ray, maximum_m, *near.plants) : plants.cast(ray, maximum_m);
        for (const std::uint32_t number : near.boxes)
            nearest_m = nearer(boxes[number], ray, nearest_m);
        return nearest_m;
    }

    /// True if a ray of the bundle, whose box is `reach`, may meet the box within this length.
    static bool mayMeet(const RayBundle& bundle, const Eigen::AlignedBox3d& reach, const PlacedBox& box,
                        double length_m) {
        return reach.squaredExteriorDistance(box.center_m) <= box.radius_m * box.radius_m + 1e-9 &&
               bundle.mayMeetColumn(box.center_m.head<2>(), box.radius_m, length_m);
    }

    double nearestBox(const RayBundle& bundle, double maximum_m) const {
        const Eigen::AlignedBox3d reach = bundle.box(maximum_m);
        double nearest_m = maximum_m;
        for (const PlacedBox& box : boxes)
            if (mayMeet(bundle, reach, box, nearest_m))
                for (const Vec3& direction : bundle.directions())
                    nearest_m = nearer(box, {bundle.origin_m(), direction}, nearest_m);
        return nearest_m;
    }

    RayHit lookAtThings(const Ray& ray, double maximum_m, const NearThings& near) const {
        const Plant* plant = nullptr;
        const PlacedBox* met_box = nullptr;
        double nearest_m =
            near.plants ? plants.look(ray, maximum_m, *near.plants, plant) : plants.look(ray, maximum_m, plant);
        for (const std::uint32_t number : near.boxes)
            if (const double hit_m = nearer(boxes[number], ray, nearest_m); hit_m < nearest_m) {
                nearest_m = hit_m;
                met_box = &boxes[number];
            }
        if (met_box)
            return {nearest_m, Met::Box,
                    normalOfBox(ray, nearest_m, met_box->center_m, met_box->box_in_map, met_box->half_size_m),
                    met_box->center_m};
        if (plant)
            return {nearest_m, isCrown(*plant, ray, nearest_m) ? Met::Crown : Met::Trunk,
                    normalOfPlant(*plant, ray, nearest_m), plant->base_in_map_m};
        return {maximum_m};
    }

    PlantIndex plants;
    TerrainRays ground;
    std::vector<PlacedBox> boxes;
    NearThings all;        ///< for rays of which nothing is known
    double top_m = 0.0;    ///< above everything, but below a ceiling if there is one
    double bottom_m = 0.0; ///< below everything
    bool roofed = false;
};

RayCaster::RayCaster(const World& world) : world_(&world), index_(std::make_unique<const Index>(world)) {}

RayCaster::~RayCaster() = default;

double RayCaster::cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const {
    return cast(origin_m, direction, maximum_m, index_->all);
}

double RayCaster::cast(const Vec3& origin_m, const Vec3& direction, double maximum_m, const NearThings& things) const {
    const Ray ray{origin_m, direction};
    // Things first: their hits shorten the walk over the ground, which costs more.
    return index_->castAtGround(ray, index_->castAtThings(ray, maximum_m, things), things);
}

double RayCaster::castNearest(const RayBundle& bundle, double maximum_m) const {
    const double at_things_m = index_->plants.castNearest(bundle, index_->nearestBox(bundle, maximum_m));
    return index_->ground.castNearest(bundle, at_things_m);
}

RayHit RayCaster::look(const Vec3& origin_m, const Vec3& direction, double maximum_m) const {
    return look(origin_m, direction, maximum_m, index_->all);
}

NearThings RayCaster::thingsNear(const RayBundle& bundle, double length_m) const {
    const Eigen::AlignedBox3d reach = bundle.box(length_m);
    NearThings near{.plants = index_->plants.near(bundle, length_m),
                    .over_ground = index_->ground.isOver(bundle.origin_m())};
    for (const std::uint32_t number : index_->all.boxes)
        if (Index::mayMeet(bundle, reach, index_->boxes[number], length_m))
            near.boxes.push_back(number);
    return near;
}

RayHit RayCaster::look(const Vec3& origin_m, const Vec3& direction, double maximum_m, const NearThings& things) const {
    const Ray ray{origin_m, direction};
    // The range is long. Downward, the ground soon ends the ray; upward, the plants limit how far to look for ground.
    const bool down = direction.z() < 0.0;
    double ground_m = down ? index_->castAtGround(ray, maximum_m, things) : maximum_m;
    RayHit hit = index_->lookAtThings(ray, ground_m, things);
    if (!down)
        ground_m = index_->castAtGround(ray, hit.distance_m, things);
    if (ground_m < hit.distance_m || (hit.met == Met::Nothing && ground_m < maximum_m))
        hit = {ground_m, Met::Ground, normalOfGround(world_->terrain, (origin_m + ground_m * direction).head<2>())};
    return hit;
}

bool RayCaster::sendsEcho(const Vec3& origin_m, const Vec3& direction, const RayHit& hit) const {
    if (hit.met == Met::Trunk || hit.met == Met::Crown)
        return true;
    double uneven_m = made_by_hand_m;
    if (hit.met == Met::Ground)
        uneven_m += unevenness_m(world_->terrain, (origin_m + hit.distance_m * direction).head<2>());
    return hit.met != Met::Nothing && std::abs(hit.normal_in_map.dot(direction)) * 8.0 * uneven_m >= sonar_wave_m;
}

bool RayCaster::roofed() const {
    return index_->roofed;
}

bool RayCaster::onRoof(const Vec3& point_m) const {
    constexpr double farthest_m = 1e5;
    return roofed() && cast(point_m, Vec3::UnitZ(), farthest_m) >= farthest_m;
}

double RayCaster::surface_m(const Vec2& point_m) const {
    const double ground_m = world_->terrain.empty() ? index_->bottom_m : world_->terrain.height_m(point_m);
    const Ray down{{point_m.x(), point_m.y(), index_->top_m}, -Vec3::UnitZ()};
    return index_->top_m - index_->castAtThings(down, index_->top_m - ground_m, index_->all);
}

double RayCaster::floorBelow_m(const Vec3& point_m) const {
    const Terrain& terrain = world_->terrain;
    const double ground_m = terrain.empty() ? index_->bottom_m : terrain.height_m(point_m.head<2>());
    const Ray down{point_m, -Vec3::UnitZ()};
    double free_m = std::max(0.0, point_m.z() - ground_m);
    for (const PlacedBox& box : index_->boxes)
        free_m = nearer(box, down, free_m);
    return point_m.z() - free_m;
}

} // namespace usar::sim
