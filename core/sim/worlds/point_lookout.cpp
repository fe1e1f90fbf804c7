#include "core/sim/worlds/made_worlds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/sim/worlds/building.h"
#include "core/sim/worlds/fractal_noise.h"

namespace usar::sim {

namespace {

constexpr double island_radius_m = 310.0;
constexpr double search_step_m = 8.0;

/// Follows the thesis's ONS-PointLookout as robots-and-worlds.md, section 5, reconstructs it; all sizes are ours. A
/// pure function of seed and point; map frame, meters, the sea's surface at 0.
class PointLookoutGround {
public:
    explicit PointLookoutGround(std::uint64_t seed) {
        Random random = seeded(seed, 5);
        coast_ = {.seed = random(), .octaves = 5, .wavelength_m = 260.0, .amplitude_m = 65.0};
        cliffs_ = {.seed = random(), .octaves = 2, .wavelength_m = 240.0, .amplitude_m = 1.0};
        hills_ = {.seed = random(), .octaves = 5, .wavelength_m = 120.0, .amplitude_m = 6.0};
        bed_ = {.seed = random(), .octaves = 4, .wavelength_m = 90.0, .amplitude_m = 2.5};
        shift_m_ = {uniform(random, 0.0, 260.0), uniform(random, 0.0, 260.0)};
        chooseLandStarts();
        chooseSeaStarts();
        for (const StartPlace& start : land_starts_)
            land_heights_m_.push_back(unlevelled_m(start.at_m));
    }

    /// Height of the land or of the sea bed.
    double height_m(const Vec2& point_m) const {
        double height_m = unlevelled_m(point_m);
        for (std::size_t i = 0; i < land_starts_.size(); ++i) {
            const double distance_m = (point_m - land_starts_[i].at_m).norm();
            if (distance_m < open_radius_m)
                height_m = std::lerp(land_heights_m_[i], height_m, smoothStep(2.5, open_radius_m, distance_m));
        }
        return height_m;
    }

    /// Approximate distance to the coast; negative at sea.
    double inland_m(const Vec2& point_m) const {
        return island_radius_m - point_m.norm() + coast_.at(point_m + shift_m_);
    }

    /// Start places on land, where the ground is level, and at sea.
    const std::vector<StartPlace>& landStarts() const { return land_starts_; }
    const std::vector<StartPlace>& seaStarts() const { return sea_starts_; }

    static constexpr double side_m = 1024.0;
    static constexpr double open_radius_m = 10.0; ///< around a start place on land

private:
    /// 1 where the coast is a cliff, 0 where it is a beach.
    double cliffs(const Vec2& point_m) const { return smoothStep(-0.35, 0.3, cliffs_.at(point_m + shift_m_)); }

    /// Height before the start places are leveled.
    double unlevelled_m(const Vec2& point_m) const {
        const double inland = inland_m(point_m);
        return inland > 0.0 ? land_m(point_m, inland) : bed_m(point_m, -inland);
    }

    double land_m(const Vec2& point_m, double inland_m) const {
        const double beach_m = 0.5 * smoothStep(0.0, 8.0, inland_m) + 6.0 * smoothStep(4.0, 120.0, inland_m);
        const double cliff_m = 16.0 * smoothStep(0.0, 7.0, inland_m);
        const double shore_m = std::lerp(beach_m, cliff_m, cliffs(point_m));
        const double plateau_m = std::lerp(shore_m, 14.0, smoothStep(60.0, 220.0, inland_m));
        return plateau_m + hills_.at(point_m + shift_m_) * smoothStep(30.0, 150.0, inland_m);
    }

    double bed_m(const Vec2& point_m, double offshore_m) const {
        const double shelf_m = 20.0 * smoothStep(0.0, 140.0, offshore_m);
        const double foot_m = 8.0 * smoothStep(0.0, 10.0, offshore_m) + 12.0 * smoothStep(0.0, 140.0, offshore_m);
        const double depth_m = std::lerp(shelf_m, foot_m, cliffs(point_m));
        return -depth_m + bed_.at(point_m + shift_m_) * smoothStep(20.0, 120.0, offshore_m);
    }

    void chooseLandStarts() {
        const auto apart = [](const Vec2& at_m, const Vec2& other_m) { return (at_m - other_m).norm() > 60.0; };
        const Vec2 top_m = bestOnGrid(256.0, search_step_m, [&](const Vec2& at_m) -> std::optional<double> {
            return apart(at_m, Vec2::Zero()) && inland_m(at_m) > 60.0 ? std::optional(unlevelled_m(at_m))
                                                                      : std::nullopt;
        });
        const Vec2 cliff_m = bestOnGrid(480.0, search_step_m, [&](const Vec2& at_m) -> std::optional<double> {
            const bool fits = inland_m(at_m) > 18.0 && inland_m(at_m) < 28.0 && apart(at_m, top_m);
            return fits ? std::optional(cliffs(at_m) + at_m.x() / 1000.0) : std::nullopt;
        });
        const Vec2 beach_m = bestOnGrid(480.0, search_step_m, [&](const Vec2& at_m) -> std::optional<double> {
            const bool fits =
                inland_m(at_m) > 35.0 && inland_m(at_m) < 45.0 && apart(at_m, top_m) && apart(at_m, cliff_m);
            return fits ? std::optional(-cliffs(at_m) - at_m.x() / 1000.0) : std::nullopt;
        });
        land_starts_ = {{"PlayerStart", Vec2::Zero(), 0.0},
                        {"HillTop", top_m, yawToward(top_m, Vec2::Zero())},
                        {"CliffTop", cliff_m, yawToward(Vec2::Zero(), cliff_m)},
                        {"Beach", beach_m, yawToward(Vec2::Zero(), beach_m)}};
    }

    void chooseSeaStarts() {
        const auto deepest = [&](const Vec2& near_m) -> Vec2 {
            return near_m + bestOnGrid(40.0, search_step_m, [&](const Vec2& offset_m) {
                       return std::optional(-unlevelled_m(near_m + offset_m));
                   });
        };
        const Vec2 open_m = deepest({0.0, -450.0});
        const Vec2 north_m = deepest({450.0, 0.0});
        const auto isDeepAround = [&](const Vec2& at_m) {
            return unlevelled_m(at_m) < -8.5 && std::ranges::all_of(ringAround(at_m, 16.0), [&](const Vec2& aside_m) {
                       return unlevelled_m(aside_m) <= -5.0;
                   });
        };
        const Vec2 bay_m = bestOnGrid(400.0, search_step_m, [&](const Vec2& at_m) -> std::optional<double> {
            return isDeepAround(at_m) ? std::optional(-at_m.norm()) : std::nullopt;
        });
        sea_starts_ = {{"OpenSea", open_m, yawToward(open_m, Vec2::Zero())},
                       {"NorthSea", north_m, pi / 2.0},
                       {"Bay", bay_m, yawToward(Vec2::Zero(), bay_m)}};
    }

    FractalNoise coast_;
    FractalNoise cliffs_;
    FractalNoise hills_;
    FractalNoise bed_;
    Vec2 shift_m_ = Vec2::Zero();
    std::vector<StartPlace> land_starts_;
    std::vector<double> land_heights_m_;
    std::vector<StartPlace> sea_starts_;
};

constexpr std::size_t posts = 1025;
constexpr int trees = 3000;
constexpr double half_m = PointLookoutGround::side_m / 2.0;
constexpr double above_water_m = 1.0;

void plantTrees(World& world, const PointLookoutGround& ground, std::uint64_t seed) {
    Random random = seeded(seed, 6);
    const FractalNoise woods{.seed = random(), .octaves = 2, .wavelength_m = 70.0, .amplitude_m = 1.0};
    Spacing trunks(half_m);
    scatter(world, trunks, trees, 500 * trees, [&]() -> std::optional<Plant> {
        const Vec2 at_m{between(random, -half_m, half_m), between(random, -half_m, half_m)};
        if (ground.inland_m(at_m) < 25.0 || !trunks.isClear(at_m, 2.5) ||
            uniform(random, 0.0, 1.0) > smoothStep(-0.4, 0.5, woods.at(at_m)) ||
            !isFarFrom(ground.landStarts(), at_m, PointLookoutGround::open_radius_m + 3.0) ||
            world.terrain.height_m(at_m) < 1.0)
            return std::nullopt;
        return makeTree(random, world.terrain, at_m);
    });
}

} // namespace

World makePointLookout(std::uint64_t seed) {
    const PointLookoutGround ground(seed);
    World world;
    world.name = "point_lookout";
    world.terrain = terrainOf({.columns = posts, .rows = posts, .step_m = 1.0, .steps_per_m = 512.0},
                              [&](const Vec2& at_m) { return ground.height_m(at_m); });
    world.water = Water{.surface_z_m = 0.0, .density_kg_m3 = 1025.0};
    addStarts(world, ground.landStarts());
    for (const StartPlace& start : ground.seaStarts())
        world.start_poses.push_back(startOver(start, above_water_m - spawn_height_m));
    plantTrees(world, ground, seed);
    return world;
}

} // namespace usar::sim
