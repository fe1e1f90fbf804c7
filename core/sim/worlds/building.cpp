#include "core/sim/worlds/building.h"

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

double wholeMillimetres(double value_m) {
    return std::round(value_m * 1000.0) / 1000.0;
}

double between(Random& random, double low_m, double high_m) {
    return wholeMillimetres(uniform(random, low_m, high_m));
}

Terrain terrainOf(const PostGrid& grid, const std::function<double(const Vec2&)>& height_m) {
    const Vec2 origin_m =
        -0.5 * grid.step_m * Vec2(static_cast<double>(grid.columns - 1), static_cast<double>(grid.rows - 1));
    std::vector<float> heights_m;
    heights_m.reserve(grid.columns * grid.rows);
    for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column) {
            const Vec2 at_m = origin_m + grid.step_m * Vec2(static_cast<double>(column), static_cast<double>(row));
            heights_m.push_back(static_cast<float>(std::round(height_m(at_m) * grid.steps_per_m) / grid.steps_per_m));
        }
    return {grid.columns, grid.rows, grid.step_m, origin_m, std::move(heights_m)};
}

double lowestGround_m(const Terrain& terrain, const Vec2& at_m, double radius_m) {
    double lowest_m = terrain.height_m(at_m);
    for (const Vec2& side_m : ringAround(at_m, radius_m))
        lowest_m = std::min(lowest_m, terrain.height_m(side_m));
    return std::floor(lowest_m * 1000.0) / 1000.0;
}

GroundRange groundUnder(const Terrain& terrain, const Vec2& center_m, const Vec2& size_m, double yaw_rad) {
    GroundRange range{terrain.height_m(center_m), terrain.height_m(center_m)};
    for (const double side : {-0.5, 0.0, 0.5})
        for (const double end : {-0.5, 0.0, 0.5}) {
            const Vec2 point_m = Eigen::Rotation2Dd(yaw_rad) * Vec2{side * size_m.x(), end * size_m.y()};
            const double z_m = terrain.height_m(center_m + point_m);
            range.lowest_m = std::min(range.lowest_m, z_m);
            range.highest_m = std::max(range.highest_m, z_m);
        }
    return range;
}

Plant makeTree(Random& random, const Terrain& terrain, const Vec2& at_m) {
    Plant tree;
    tree.trunk_radius_m = between(random, 0.12, 0.32);
    tree.trunk_height_m = between(random, 3.0, 7.0);
    tree.crown = uniform(random, 0.0, 1.0) < 0.5 ? CrownShape::Sphere : CrownShape::Cone;
    tree.crown_radius_m = between(random, 1.0, 2.5);
    if (tree.crown == CrownShape::Cone)
        tree.crown_height_m = between(random, 3.0, 6.0);
    tree.base_in_map_m = {at_m.x(), at_m.y(), lowestGround_m(terrain, at_m, tree.trunk_radius_m)};
    return tree;
}

void scatter(World& world, Spacing& trunks, int wanted, int most_tries,
             const std::function<std::optional<Plant>()>& tryOne) {
    for (int planted = 0, tries = 0; planted < wanted && tries < most_tries; ++tries)
        if (const auto plant = tryOne()) {
            world.plants.push_back(*plant);
            trunks.add(plant->base_in_map_m.head<2>());
            ++planted;
        }
}

std::array<Vec2, 8> ringAround(const Vec2& center_m, double radius_m) {
    std::array<Vec2, 8> points_m;
    for (int i = 0; i < 8; ++i)
        points_m[static_cast<std::size_t>(i)] =
            center_m + radius_m * Vec2{std::cos(pi * i / 4.0), std::sin(pi * i / 4.0)};
    return points_m;
}

Box block(const Vec3& low_m, const Vec3& high_m) {
    return {{.position_m = (low_m + high_m) / 2.0}, high_m - low_m};
}

void buildHall(World& world, const Vec3& size_m) {
    constexpr double wall_m = 0.5;
    const double x = size_m.x() / 2.0;
    const double y = size_m.y() / 2.0;
    const double out_x = x + wall_m;
    const double out_y = y + wall_m;
    // Walls reach below the floor and into the roof and overlap at their corners, so that no ray finds a gap.
    const double low = -wall_m;
    const double high = size_m.z() + wall_m;
    world.boxes = {block({x, -out_y, low}, {out_x, out_y, high}), block({-out_x, -out_y, low}, {-x, out_y, high}),
                   block({-out_x, y, low}, {out_x, out_y, high}), block({-out_x, -out_y, low}, {out_x, -y, high}),
                   block({-out_x, -out_y, size_m.z()}, {out_x, out_y, high})};
    world.terrain = Terrain::level({{-out_x, -out_y}, {out_x, out_y}}, 0.0).value();
}

Box beam(const Vec3& from_m, const Vec3& to_m, double width_m, double thickness_m) {
    const Vec3 along_m = to_m - from_m;
    return {{.position_m = (from_m + to_m) / 2.0,
             .pitch_rad = -std::atan2(along_m.z(), along_m.head<2>().norm()),
             .yaw_rad = std::atan2(along_m.y(), along_m.x())},
            {wholeMillimetres(along_m.norm()), width_m, thickness_m}};
}

Box slab(const Vec3& from_m, const Vec3& to_m, double width_m, double thickness_m) {
    Box box = beam(from_m, to_m, width_m, thickness_m);
    box.center_in_map.position_m -= box.center_in_map.rotation() * Vec3(0.0, 0.0, thickness_m / 2.0);
    return box;
}

NamedPose startOver(const StartPlace& place, double ground_z_m) {
    return {place.name,
            {.position_m = {place.at_m.x(), place.at_m.y(), wholeMillimetres(ground_z_m + spawn_height_m)},
             .yaw_rad = wholeMillimetres(place.yaw_rad)}};
}

void addStarts(World& world, const std::vector<StartPlace>& places) {
    for (const StartPlace& place : places)
        world.start_poses.push_back(startOver(place, world.terrain.height_m(place.at_m)));
}

bool isFarFrom(const std::vector<StartPlace>& places, const Vec2& point_m, double distance_m) {
    return std::ranges::all_of(places,
                               [&](const StartPlace& place) { return (point_m - place.at_m).norm() > distance_m; });
}

Vec2 bestOnGrid(double half_m, double step_m, const std::function<std::optional<double>(const Vec2&)>& score) {
    Vec2 best_m = Vec2::Zero();
    double best = -1e300;
    for (double y = -half_m; y <= half_m; y += step_m)
        for (double x = -half_m; x <= half_m; x += step_m)
            if (const auto value = score({x, y}); value && *value > best) {
                best = *value;
                best_m = {x, y};
            }
    return best_m;
}

double yawToward(const Vec2& from_m, const Vec2& to_m) {
    return std::atan2(to_m.y() - from_m.y(), to_m.x() - from_m.x());
}

} // namespace usar::sim
