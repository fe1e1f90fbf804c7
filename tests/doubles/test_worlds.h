// Small worlds made in code, so that tests need no files: flat ground, rough ground, a thicket.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/sim/world/world.h"

namespace usar::doubles {

/// Ground of `posts` x `posts`, centered on the map's origin, with the height that `height_m(x, y)` says.
inline sim::Terrain terrainOf(std::size_t posts, double step_m,
                              const std::function<double(double x_m, double y_m)>& height_m) {
    const double half_m = step_m * static_cast<double>(posts - 1) / 2.0;
    std::vector<float> heights_m;
    heights_m.reserve(posts * posts);
    for (std::size_t row = 0; row < posts; ++row)
        for (std::size_t column = 0; column < posts; ++column)
            heights_m.push_back(static_cast<float>(
                height_m(static_cast<double>(column) * step_m - half_m, static_cast<double>(row) * step_m - half_m)));
    return {posts, posts, step_m, Vec2::Constant(-half_m), std::move(heights_m)};
}

/// A square of level ground at `ground_z_m` around the origin, one start pose `PlayerStart` 0.35 m above its center.
inline sim::World flatWorld(double side_m = 64.0, double ground_z_m = 0.0) {
    sim::World world;
    world.name = "flat";
    const double step_m = 0.5;
    world.terrain = terrainOf(static_cast<std::size_t>(side_m / step_m) + 1, step_m,
                              [ground_z_m](double, double) { return ground_z_m; });
    world.start_poses = {{"PlayerStart", Pose{.position_m = {0.0, 0.0, ground_z_m + 0.35}}}};
    return world;
}

/// Random heights on every post: the roughest ground that a grid can hold.
inline sim::World roughWorld(std::uint64_t seed, std::size_t posts = 41, double step_m = 0.5, double range_m = 2.0) {
    Random random = seeded(seed, 1);
    sim::World world = flatWorld();
    world.name = "rough";
    world.terrain = terrainOf(posts, step_m, [&](double, double) { return uniform(random, -range_m, range_m); });
    return world;
}

/// Gentle waves, +-2 m, with `trees` trees of both crowns at random places; they may overlap.
inline sim::World woodedWorld(std::uint64_t seed, std::size_t trees = 60, double side_m = 64.0) {
    Random random = seeded(seed, 2);
    sim::World world = flatWorld();
    world.name = "wood";
    const double step_m = 0.25;
    world.terrain = terrainOf(static_cast<std::size_t>(side_m / step_m) + 1, step_m,
                              [](double x, double y) { return std::sin(x / 5.0) + std::cos(y / 7.0); });
    const double half_m = side_m / 2.0 - 3.0;
    for (std::size_t i = 0; i < trees; ++i) {
        const Vec2 at_m{uniform(random, -half_m, half_m), uniform(random, -half_m, half_m)};
        sim::Plant plant;
        plant.base_in_map_m = {at_m.x(), at_m.y(), world.terrain.height_m(at_m)};
        plant.trunk_radius_m = uniform(random, 0.12, 0.32);
        plant.trunk_height_m = uniform(random, 3.0, 7.0);
        plant.crown = i % 2 == 0 ? sim::CrownShape::Sphere : sim::CrownShape::Cone;
        plant.crown_radius_m = uniform(random, 1.0, 2.5);
        plant.crown_height_m = plant.crown == sim::CrownShape::Cone ? uniform(random, 3.0, 6.0) : 0.0;
        world.plants.push_back(plant);
    }
    return world;
}

} // namespace usar::doubles
