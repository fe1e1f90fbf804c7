#include "core/sim/worlds/made_worlds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/random.h"
#include "core/sim/worlds/building.h"
#include "core/sim/worlds/fractal_noise.h"

namespace usar::sim {

namespace {

constexpr double ravine_depth_m = 8.0;
constexpr double ravine_half_width_m = 6.0;
constexpr double pond_depth_m = 4.0;
constexpr double pond_fill_m = 2.6;
constexpr double pond_radius_m = 13.0;

double bell(double distance, double width) {
    return std::exp(-(distance / width) * (distance / width));
}

/// Follows the thesis's DM-TallTestWorld as robots-and-worlds.md, section 5, reconstructs it; all sizes are ours. A
/// pure function of seed and point; map frame, meters.
class TallTestGround {
public:
    explicit TallTestGround(std::uint64_t seed) {
        Random random = seeded(seed, 1);
        hills_.seed = random();
        shift_m_ = {uniform(random, 0.0, 80.0), uniform(random, 0.0, 80.0)};
        bend_rad_ = uniform(random, -pi, pi);
        wiggle_rad_ = uniform(random, -pi, pi);
        chooseStarts();
        choosePond();
        for (const StartPlace& start : starts_)
            start_heights_m_.push_back(unlevelled_m(start.at_m));
    }

    /// Height of the ground, also under the pond.
    double height_m(const Vec2& point_m) const {
        double height_m = unlevelled_m(point_m);
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            const double level = 1.0 - smoothStep(2.5, open_radius_m, (point_m - starts_[i].at_m).norm());
            height_m = std::lerp(height_m, start_heights_m_[i], level);
        }
        return height_m;
    }

    /// Height of the pond's surface.
    double water_z_m() const { return water_z_m_; }
    const std::vector<StartPlace>& starts() const { return starts_; }

    /// Distance to the center line of the ravine, accurate only near it.
    double ravineDistance_m(const Vec2& point_m) const {
        const double slope = ravineLine_m(point_m.x() + 0.5) - ravineLine_m(point_m.x() - 0.5);
        return std::abs(point_m.y() - ravineLine_m(point_m.x())) / std::hypot(1.0, slope);
    }

    static constexpr double side_m = 256.0;
    static constexpr double open_radius_m = 10.0; ///< around a start place

private:
    // Noise is level at its lattice points, one of which is the origin. The shift keeps start places off them.
    double hills_m(const Vec2& point_m) const { return hills_.at(point_m + shift_m_); }

    /// The y of the ravine's center line.
    double ravineLine_m(double x_m) const {
        return -62.0 + 14.0 * std::sin(x_m / 27.0 + bend_rad_) + 6.0 * std::sin(x_m / 11.0 + wiggle_rad_);
    }

    double hillsAndRavine_m(const Vec2& point_m) const {
        return hills_m(point_m) - ravine_depth_m * bell(ravineDistance_m(point_m), ravine_half_width_m);
    }

    /// Height before the start places are leveled.
    double unlevelled_m(const Vec2& point_m) const {
        return hillsAndRavine_m(point_m) - pond_depth_m * bell((point_m - pond_m_).norm(), pond_radius_m);
    }

    void chooseStarts() {
        const Vec2 ravine_edge_m{32.0, std::round(ravineLine_m(32.0)) + 16.0};
        const Vec2 corner_m{104.0, 104.0};
        const Vec2 top_m = bestOnGrid(100.0, 4.0, [&](const Vec2& at_m) -> std::optional<double> {
            const bool apart = at_m.norm() > 45.0 && (at_m - corner_m).norm() > 30.0 && at_m.y() > -20.0;
            return apart ? std::optional(hills_m(at_m)) : std::nullopt;
        });
        starts_ = {{"PlayerStart", Vec2::Zero(), 0.0},
                   {"HillTop", top_m, yawToward(top_m, Vec2::Zero())},
                   {"RavineEdge", ravine_edge_m, -pi / 2.0},
                   {"FarCorner", corner_m, yawToward(corner_m, Vec2::Zero())}};
    }

    void choosePond() {
        pond_m_ = bestOnGrid(96.0, 4.0, [&](const Vec2& at_m) -> std::optional<double> {
            if (ravineDistance_m(at_m) < 35.0)
                return std::nullopt;
            for (const StartPlace& start : starts_)
                if ((at_m - start.at_m).norm() < 45.0)
                    return std::nullopt;
            return -hills_m(at_m);
        });
        water_z_m_ = std::round((unlevelled_m(pond_m_) + pond_fill_m) * 100.0) / 100.0;
    }

    FractalNoise hills_;
    Vec2 shift_m_ = Vec2::Zero();
    double bend_rad_ = 0.0;
    double wiggle_rad_ = 0.0;
    Vec2 pond_m_ = Vec2::Zero();
    double water_z_m_ = 0.0;
    std::vector<StartPlace> starts_;
    std::vector<double> start_heights_m_;
};

constexpr std::size_t posts = 1025;
constexpr int trees = 2000;
constexpr int bushes = 200;
constexpr int houses = 3;
constexpr double half_m = TallTestGround::side_m / 2.0;

/// True in the area of the quick scan and a margin around it, where there are few enough trees to fly between but
/// enough to make a wood.
bool isMeadow(const Vec2& at_m) {
    return std::abs(at_m.x()) < 36.0 && std::abs(at_m.y()) < 26.0;
}

/// Places things one after the other, each of them clear of those placed before.
class Planter {
public:
    Planter(World& world, const TallTestGround& ground, std::uint64_t seed)
        : world_(world)
        , ground_(ground)
        , random_(seeded(seed, 2))
        , woods_{.seed = random_(), .octaves = 2, .wavelength_m = 45.0, .amplitude_m = 1.0} {}

    void build() {
        for (int tries = 0; tries < 2000 && world_.boxes.size() < houses; ++tries)
            if (const auto box = house())
                world_.boxes.push_back(*box);
    }

    void plantTrees() {
        scatter(world_, trunks_, trees, 500 * trees, [&]() -> std::optional<Plant> {
            const Vec2 at_m = anywhere();
            if (!growsHere(at_m) || !trunks_.isClear(at_m, isMeadow(at_m) ? 6.5 : 2.5))
                return std::nullopt;
            const Plant tree = makeTree(random_, world_.terrain, at_m);
            return isFree(at_m, tree.crown_radius_m) ? std::optional(tree) : std::nullopt;
        });
    }

    void plantBushes() {
        scatter(world_, trunks_, bushes, 500 * bushes, [&]() -> std::optional<Plant> {
            const Vec2 at_m = anywhere();
            Plant bush;
            bush.crown_radius_m = between(random_, 0.4, 1.0);
            if (!isFree(at_m, bush.crown_radius_m) || !trunks_.isClear(at_m, 1.5))
                return std::nullopt;
            bush.base_in_map_m = {at_m.x(), at_m.y(), lowestGround_m(world_.terrain, at_m, 0.0)};
            return bush;
        });
    }

private:
    Vec2 anywhere() {
        return {between(random_, -half_m + 3.0, half_m - 3.0), between(random_, -half_m + 3.0, half_m - 3.0)};
    }

    bool isFree(const Vec2& at_m, double radius_m) const {
        if (ground_.height_m(at_m) < ground_.water_z_m() + 0.3)
            return false;
        return isFarFrom(ground_.starts(), at_m, TallTestGround::open_radius_m + radius_m) &&
               std::ranges::all_of(world_.boxes, [&](const Box& box) {
                   const double reach_m = box.size_m.head<2>().norm() / 2.0;
                   return (at_m - box.center_in_map.position_m.head<2>()).norm() > reach_m + radius_m + 1.0;
               });
    }

    bool growsHere(const Vec2& at_m) {
        const double density = isMeadow(at_m) ? 0.35 : smoothStep(-0.35, 0.55, woods_.at(at_m));
        return uniform(random_, 0.0, 1.0) < density;
    }

    std::optional<Box> house() {
        const Vec2 at_m{between(random_, -110.0, 110.0), between(random_, -110.0, 110.0)};
        const Vec2 size_m{between(random_, 7.0, 9.0), between(random_, 9.0, 13.0)};
        const double yaw_rad = between(random_, -pi, pi);
        const double wall_m = between(random_, 3.5, 5.5);
        const double reach_m = size_m.norm() / 2.0;
        if (!isFree(at_m, reach_m) || isMeadow(at_m) || ground_.ravineDistance_m(at_m) < 20.0)
            return std::nullopt;
        const auto [lowest_m, highest_m] = groundUnder(world_.terrain, at_m, size_m, yaw_rad);
        if (highest_m - lowest_m > 3.0)
            return std::nullopt;
        const double floor_m = wholeMillimetres(lowest_m - 0.5);
        const double height_m = wholeMillimetres(highest_m + wall_m - floor_m);
        Box box;
        box.size_m = {size_m.x(), size_m.y(), height_m};
        box.center_in_map = {.position_m = {at_m.x(), at_m.y(), floor_m + height_m / 2.0}, .yaw_rad = yaw_rad};
        return box;
    }

    World& world_;
    const TallTestGround& ground_;
    Random random_;
    FractalNoise woods_;
    Spacing trunks_{half_m};
};

} // namespace

World makeTallTest(std::uint64_t seed) {
    const TallTestGround ground(seed);
    World world;
    world.name = "tall_test";
    world.terrain = terrainOf({posts, posts, TallTestGround::side_m / static_cast<double>(posts - 1)},
                              [&](const Vec2& at_m) { return ground.height_m(at_m); });
    world.water = Water{.surface_z_m = ground.water_z_m()};
    addStarts(world, ground.starts());
    Planter planter(world, ground, seed);
    planter.build();
    planter.plantTrees();
    planter.plantBushes();
    return world;
}

} // namespace usar::sim
