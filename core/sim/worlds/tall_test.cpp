#include "core/sim/worlds/tall_test.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/random.h"
#include "core/sim/worlds/building.h"
#include "core/sim/worlds/spacing.h"
#include "core/sim/worlds/tall_test_ground.h"

namespace usar::sim {

namespace {

constexpr std::size_t posts = 1025;
constexpr int trees = 2000;
constexpr int bushes = 200;
constexpr int houses = 3;
constexpr double half_m = TallTestGround::side_m / 2.0;

/// Places things one after the other, each of them clear of those placed before.
class Planter {
public:
    Planter(World& world, const TallTestGround& ground, std::uint64_t seed)
        : world_(world)
        , ground_(ground)
        , random_(seeded(seed, 2))
        , woods_{.seed = random_(), .octaves = 2, .wavelength_m = 45.0, .amplitude_m = 1.0} {}

    void build();
    void plantTrees();
    void plantBushes();

private:
    Vec2 anywhere() {
        return {between(random_, -half_m + 3.0, half_m - 3.0), between(random_, -half_m + 3.0, half_m - 3.0)};
    }
    bool isFree(const Vec2& at_m, double radius_m) const;
    bool growsHere(const Vec2& at_m);
    std::optional<Box> house();

    World& world_;
    const TallTestGround& ground_;
    Random random_;
    FractalNoise woods_;
    Spacing trunks_{half_m};
};

/// True in the area of the quick scan and a margin around it, where there are few enough trees to fly between but
/// enough to make a wood.
bool isMeadow(const Vec2& at_m) {
    return std::abs(at_m.x()) < 36.0 && std::abs(at_m.y()) < 26.0;
}

bool Planter::isFree(const Vec2& at_m, double radius_m) const {
    if (ground_.height_m(at_m) < ground_.water_z_m() + 0.3)
        return false;
    const auto& starts = ground_.starts();
    const bool keeps_starts = std::all_of(starts.begin(), starts.end(), [&](const StartPlace& start) {
        return (at_m - start.at_m).norm() > TallTestGround::open_radius_m + radius_m;
    });
    return keeps_starts && std::all_of(world_.boxes.begin(), world_.boxes.end(), [&](const Box& box) {
               const double reach_m = box.size_m.head<2>().norm() / 2.0;
               return (at_m - box.center_in_map.position_m.head<2>()).norm() > reach_m + radius_m + 1.0;
           });
}

bool Planter::growsHere(const Vec2& at_m) {
    const double density = isMeadow(at_m) ? 0.35 : smoothStep(-0.35, 0.55, woods_.at(at_m));
    return uniform(random_, 0.0, 1.0) < density;
}

void Planter::plantTrees() {
    // This is a bound on the tries, far above the number needed.
    for (int planted = 0, tries = 0; planted < trees && tries < 500 * trees; ++tries) {
        const Vec2 at_m = anywhere();
        if (!growsHere(at_m) || !trunks_.isClear(at_m, isMeadow(at_m) ? 6.5 : 2.5))
            continue;
        const Plant plant = makeTree(random_, world_.terrain, at_m);
        if (!isFree(at_m, plant.crown_radius_m))
            continue;
        world_.plants.push_back(plant);
        trunks_.add(at_m);
        ++planted;
    }
}

void Planter::plantBushes() {
    for (int planted = 0, tries = 0; planted < bushes && tries < 500 * bushes; ++tries) {
        const Vec2 at_m = anywhere();
        Plant bush;
        bush.crown_radius_m = between(random_, 0.4, 1.0);
        if (!isFree(at_m, bush.crown_radius_m) || !trunks_.isClear(at_m, 1.5))
            continue;
        bush.base_in_map_m = {at_m.x(), at_m.y(), lowestGround_m(world_.terrain, at_m, 0.0)};
        world_.plants.push_back(bush);
        trunks_.add(at_m);
        ++planted;
    }
}

std::optional<Box> Planter::house() {
    const Vec2 at_m{between(random_, -110.0, 110.0), between(random_, -110.0, 110.0)};
    const Vec2 size_m{between(random_, 7.0, 9.0), between(random_, 9.0, 13.0)};
    const double yaw_rad = between(random_, -pi, pi);
    const double wall_m = between(random_, 3.5, 5.5);
    const double reach_m = size_m.norm() / 2.0;
    if (!isFree(at_m, reach_m) || isMeadow(at_m) || ground_.ravineDistance_m(at_m) < 20.0)
        return std::nullopt;
    double lowest_m = world_.terrain.height_m(at_m);
    double highest_m = lowest_m;
    for (const double side : {-0.5, 0.0, 0.5})
        for (const double end : {-0.5, 0.0, 0.5}) {
            const Vec2 corner_m = Eigen::Rotation2Dd(yaw_rad) * Vec2{side * size_m.x(), end * size_m.y()};
            const double z_m = world_.terrain.height_m(at_m + corner_m);
            lowest_m = std::min(lowest_m, z_m);
            highest_m = std::max(highest_m, z_m);
        }
    if (highest_m - lowest_m > 3.0)
        return std::nullopt;
    const double floor_m = wholeMillimetres(lowest_m - 0.5);
    const double height_m = wholeMillimetres(highest_m + wall_m - floor_m);
    Box box;
    box.size_m = {size_m.x(), size_m.y(), height_m};
    box.center_in_map = {.position_m = {at_m.x(), at_m.y(), floor_m + height_m / 2.0}, .yaw_rad = yaw_rad};
    return box;
}

void Planter::build() {
    for (int tries = 0; tries < 2000 && world_.boxes.size() < houses; ++tries)
        if (const auto box = house())
            world_.boxes.push_back(*box);
}

} // namespace

World makeTallTest(std::uint64_t seed) {
    const TallTestGround ground(seed);
    World world;
    world.name = "tall_test";
    world.terrain = terrainOf({posts, posts, TallTestGround::side_m / static_cast<double>(posts - 1)},
                              [&](const Vec2& at_m) { return ground.height_m(at_m); });
    world.water = Water{.surface_z_m = ground.water_z_m()};
    for (const StartPlace& start : ground.starts())
        world.start_poses.push_back(startOver(start, world.terrain.height_m(start.at_m)));
    Planter planter(world, ground, seed);
    planter.build();
    planter.plantTrees();
    planter.plantBushes();
    return world;
}

} // namespace usar::sim
