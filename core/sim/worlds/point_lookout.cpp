#include "core/sim/worlds/point_lookout.h"

#include <algorithm>

#include "core/sim/worlds/building.h"
#include "core/sim/worlds/point_lookout_ground.h"
#include "core/sim/worlds/spacing.h"

namespace usar::sim {

namespace {

constexpr std::size_t posts = 1025;
constexpr int trees = 3000;
constexpr double half_m = PointLookoutGround::side_m / 2.0;
constexpr double above_water_m = 1.0;

void plantTrees(World& world, const PointLookoutGround& ground, std::uint64_t seed) {
    Random random = seeded(seed, 6);
    const FractalNoise woods{.seed = random(), .octaves = 2, .wavelength_m = 70.0, .amplitude_m = 1.0};
    Spacing trunks(half_m);
    for (int planted = 0, tries = 0; planted < trees && tries < 500 * trees; ++tries) {
        const Vec2 at_m{between(random, -half_m, half_m), between(random, -half_m, half_m)};
        if (ground.inland_m(at_m) < 25.0 || !trunks.isClear(at_m, 2.5) ||
            uniform(random, 0.0, 1.0) > smoothStep(-0.4, 0.5, woods.at(at_m)))
            continue;
        const auto& starts = ground.landStarts();
        const bool keeps_starts = std::all_of(starts.begin(), starts.end(), [&](const StartPlace& start) {
            return (at_m - start.at_m).norm() > PointLookoutGround::open_radius_m + 3.0;
        });
        if (!keeps_starts || world.terrain.height_m(at_m) < 1.0)
            continue;
        world.plants.push_back(makeTree(random, world.terrain, at_m));
        trunks.add(at_m);
        ++planted;
    }
}

} // namespace

World makePointLookout(std::uint64_t seed) {
    const PointLookoutGround ground(seed);
    World world;
    world.name = "point_lookout";
    world.terrain = terrainOf({.columns = posts, .rows = posts, .step_m = 1.0, .steps_per_m = 512.0},
                              [&](const Vec2& at_m) { return ground.height_m(at_m); });
    world.water = Water{.surface_z_m = 0.0, .density_kg_m3 = 1025.0};
    for (const StartPlace& start : ground.landStarts())
        world.start_poses.push_back(startOver(start, world.terrain.height_m(start.at_m)));
    for (const StartPlace& start : ground.seaStarts())
        world.start_poses.push_back(startOver(start, above_water_m - spawn_height_m));
    plantTrees(world, ground, seed);
    return world;
}

} // namespace usar::sim
