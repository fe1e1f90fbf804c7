#include "core/sim/worlds/building.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

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

} // namespace usar::sim
