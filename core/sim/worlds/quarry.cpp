#include "core/sim/worlds/made_worlds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/sim/worlds/building.h"
#include "core/sim/worlds/fractal_noise.h"

namespace usar::sim {

namespace {

constexpr double half_m = 75.0;
constexpr std::size_t posts = 601;
constexpr std::size_t faces = 4;
constexpr double face_run_m = 1.2; ///< from the foot of a face to its top, seen from above
constexpr double road_half_m = 3.0;
constexpr double road_reach_m = 4.5; ///< of its banks, from the middle of the road
constexpr double pond_depth_m = 4.0;
constexpr double pond_width_m = 8.0;
constexpr double shore_m = 0.6; ///< from the pond's surface up to the floor of the pit
constexpr double open_radius_m = 5.0;
constexpr int ledges = 8;
constexpr int boulders = 45;
constexpr int trees = 120;

/// Faces and benches around the origin, of which the seed makes a crooked ring. A pure function of seed and point; map
/// frame, meters; the rim is at 0.
class QuarryGround {
public:
    explicit QuarryGround(std::uint64_t seed) {
        Random random = seeded(seed, 13);
        wobble_ = {.seed = random(), .octaves = 3, .wavelength_m = 45.0, .amplitude_m = 4.0};
        hills_ = {.seed = random(), .octaves = 4, .wavelength_m = 35.0, .amplitude_m = 2.5};
        roughness_ = {.seed = random(), .octaves = 3, .wavelength_m = 3.0, .amplitude_m = 0.06};
        shift_m_ = {uniform(random, 0.0, 90.0), uniform(random, 0.0, 90.0)};
        road_begin_rad_ = uniform(random, -pi, pi);
        road_turn_ = uniform(random, 0.0, 1.0) < 0.5 ? -1.0 : 1.0;
        foot_m_[0] = 20.0;
        for (std::size_t i = 0; i < faces; ++i) {
            rise_m_[i] = between(random, 4.5, 7.5);
            floor_z_m_ -= rise_m_[i];
            if (i > 0)
                foot_m_[i] = foot_m_[i - 1] + between(random, 10.0, 12.0);
        }
        pond_m_ = -3.0 * awayAt(0.5);
        chooseStarts();
    }

    double height_m(const Vec2& at_m) const {
        const double reach_m = bentDistance_m(at_m);
        const double turn = turned(at_m);
        const double calm = calmAt(at_m);
        const double rim_m = foot_m_[faces - 1] + 9.0;
        const double on_road = 1.0 - smoothStep(road_half_m, road_reach_m, std::abs(reach_m - roadReach_m(turn)));
        double height_m = std::lerp(terrace_m(reach_m), roadHeight_m(turn), on_road);
        height_m += calm * roughness_.at(at_m + shift_m_);
        if (reach_m > rim_m)
            height_m += calm * hills_.at(at_m + shift_m_) * smoothStep(rim_m, rim_m + 12.0, reach_m);
        return height_m - pond_depth_m * bell((at_m - pond_m_).norm() / pond_width_m);
    }

    /// Distance to the middle of the road; accurate only near it.
    double roadDistance_m(const Vec2& at_m) const { return std::abs(bentDistance_m(at_m) - roadReach_m(turned(at_m))); }

    double waterZ_m() const { return floor_z_m_ - shore_m; }
    const std::vector<StartPlace>& starts() const { return starts_; }

    /// Distance from the origin, bent by noise: faces are where it equals `foot_m`.
    double bentDistance_m(const Vec2& at_m) const { return at_m.norm() + wobble_.at(at_m + shift_m_); }
    double foot_m(std::size_t face) const { return foot_m_[face]; }
    /// Height of the bench above a face.
    double bench_z_m(std::size_t face) const { return terrace_m(foot_m_[face] + face_run_m); }

    /// The direction from the origin where this share of the road is behind.
    Vec2 awayAt(double share) const {
        const double bearing_rad = road_begin_rad_ + road_turn_ * 2.0 * pi * share;
        return {std::cos(bearing_rad), std::sin(bearing_rad)};
    }

    /// The point in this direction where the bent distance has this value.
    Vec2 pointAt(const Vec2& away, double reach_m) const {
        double near_m = 0.0;
        double far_m = 2.0 * half_m;
        for (int i = 0; i < 40; ++i) {
            const double middle_m = (near_m + far_m) / 2.0;
            (bentDistance_m(middle_m * away) < reach_m ? near_m : far_m) = middle_m;
        }
        return near_m * away;
    }

private:
    static double bell(double x) { return std::exp(-x * x); }

    double terrace_m(double reach_m) const {
        double height_m = floor_z_m_;
        for (std::size_t i = 0; i < faces; ++i)
            height_m += rise_m_[i] * smoothStep(foot_m_[i], foot_m_[i] + face_run_m, reach_m);
        return height_m;
    }

    /// How much of the road's turn is behind in this direction, 0 to 1.
    double turned(const Vec2& at_m) const {
        const double turn = road_turn_ * (bearingOf(at_m) - road_begin_rad_) / (2.0 * pi);
        return turn - std::floor(turn);
    }

    double roadReach_m(double share) const { return std::lerp(foot_m_[faces - 1] + 5.0, foot_m_[0] - 3.0, share); }

    /// The road falls evenly with its length, which is longer for the same turn farther out.
    double roadHeight_m(double share) const {
        const double outer_m = roadReach_m(0.0);
        const double inner_m = roadReach_m(1.0);
        return floor_z_m_ * (outer_m * share - (outer_m - inner_m) * share * share / 2.0) / ((outer_m + inner_m) / 2.0);
    }

    /// 0 where robots start, 1 elsewhere.
    double calmAt(const Vec2& at_m) const {
        double calm = 1.0;
        for (const StartPlace& start : starts_)
            calm = std::min(calm, smoothStep(2.5, open_radius_m, (at_m - start.at_m).norm()));
        return calm;
    }

    void chooseStarts() {
        const auto bench = [&](const char* name, std::size_t face, double share) -> StartPlace {
            const Vec2 at_m = pointAt(awayAt(share), (foot_m_[face] + face_run_m + foot_m_[face + 1]) / 2.0);
            return {name, at_m, yawToward(at_m, Vec2::Zero())};
        };
        const Vec2 rim_m = pointAt(awayAt(0.55), foot_m_[faces - 1] + 7.0);
        const Vec2 pit_m = pointAt(awayAt(0.5), 15.0);
        starts_ = {bench("PlayerStart", 1, 0.15),
                   bench("UpperBench", 2, 0.75),
                   bench("LowerBench", 0, 0.3),
                   {"Rim", rim_m, yawToward(rim_m, Vec2::Zero())},
                   {"PitFloor", pit_m, yawToward(pit_m, pond_m_)}};
        for (StartPlace& start : starts_)
            start.at_m = start.at_m.unaryExpr(&wholeMillimetres);
    }

    FractalNoise wobble_;
    FractalNoise hills_;
    FractalNoise roughness_;
    Vec2 shift_m_ = Vec2::Zero();
    double road_begin_rad_ = 0.0;
    double road_turn_ = 1.0; ///< -1: it leads down clockwise
    std::array<double, faces> foot_m_{};
    std::array<double, faces> rise_m_{};
    double floor_z_m_ = 0.0;
    Vec2 pond_m_ = Vec2::Zero();
    std::vector<StartPlace> starts_;
};

/// Puts rocks into the quarry: ledges over benches first, then boulders.
class RockBuilder {
public:
    RockBuilder(World& world, const QuarryGround& ground, std::uint64_t seed)
        : world_(world)
        , ground_(ground)
        , random_(seeded(seed, 14)) {}

    void build() {
        for (int tries = 0, found = 0; found < ledges && tries < 100 * ledges; ++tries)
            found += tryLedge(static_cast<std::size_t>(found) % faces) ? 1 : 0;
        for (int tries = 0, found = 0; found < boulders && tries < 100 * boulders; ++tries)
            found += tryBoulder() ? 1 : 0;
    }

private:
    /// A slab that lies level in the top of a face and juts out over the bench below it.
    bool tryLedge(std::size_t face) {
        const Vec2 away = ground_.awayAt(uniform(random_, 0.0, 1.0));
        const Vec2 foot_m = ground_.pointAt(away, ground_.foot_m(face));
        const double width_m = between(random_, 4.0, 7.0);
        const double thickness_m = between(random_, 1.0, 1.6);
        const double over_m = between(random_, 2.2, 3.2);
        const double z_m = wholeMillimetres(ground_.bench_z_m(face) + between(random_, 0.1, 0.3));
        if (ground_.roadDistance_m(foot_m) < 11.0 || !isFarFrom(ground_.starts(), foot_m, 12.0) ||
            !rocks_.isClear(foot_m, 9.0))
            return false;
        const Vec2 outer_m = foot_m - over_m * away;
        const Vec2 inner_m = foot_m + 3.5 * away;
        world_.boxes.push_back(
            slab({inner_m.x(), inner_m.y(), z_m}, {outer_m.x(), outer_m.y(), z_m}, width_m, thickness_m));
        rocks_.add(foot_m);
        return true;
    }

    /// Two boxes through one another, turned any way and sunk into the ground by a quarter of their size.
    bool tryBoulder() {
        const bool at_foot = uniform(random_, 0.0, 1.0) < 0.7;
        const auto face = static_cast<std::size_t>(uniform(random_, 0.0, static_cast<double>(faces)));
        const double reach_m =
            at_foot ? ground_.foot_m(face) - between(random_, 1.2, 3.5) : between(random_, 12.0, 70.0);
        const Vec2 point_m = ground_.pointAt(ground_.awayAt(uniform(random_, 0.0, 1.0)), reach_m);
        const Vec2 at_m{wholeMillimetres(point_m.x()), wholeMillimetres(point_m.y())};
        const double size_m = between(random_, 0.6, 2.4);
        const auto [lowest_m, highest_m] = groundUnder(world_.terrain, at_m, Vec2::Constant(size_m), 0.0);
        if (highest_m - lowest_m > 0.6 || lowest_m < ground_.waterZ_m() + 0.2 ||
            at_m.cwiseAbs().maxCoeff() > half_m - 3.0 || ground_.roadDistance_m(at_m) < road_reach_m + size_m ||
            !rocks_.isClear(at_m, 5.0) || !isFarFrom(ground_.starts(), at_m, open_radius_m + size_m))
            return false;
        for (int part = 0; part < 2; ++part) {
            Box box;
            box.size_m = {size_m, between(random_, 0.7, 1.0) * size_m, between(random_, 0.6, 0.9) * size_m};
            box.size_m = box.size_m.unaryExpr(&wholeMillimetres);
            box.center_in_map = {.position_m = {at_m.x(), at_m.y(), wholeMillimetres(lowest_m + 0.15 * size_m)},
                                 .roll_rad = between(random_, 0.1, 0.6),
                                 .pitch_rad = between(random_, 0.1, 0.6),
                                 .yaw_rad = between(random_, -pi, pi)};
            world_.boxes.push_back(box);
        }
        rocks_.add(at_m);
        return true;
    }

    World& world_;
    const QuarryGround& ground_;
    Random random_;
    Spacing rocks_{2.0 * half_m};
};

/// Woods around the pit.
void plantTrees(World& world, const QuarryGround& ground, std::uint64_t seed) {
    Random random = seeded(seed, 15);
    Spacing trunks(half_m);
    scatter(world, trunks, trees, 500 * trees, [&]() -> std::optional<Plant> {
        const Vec2 at_m{between(random, -half_m + 1.0, half_m - 1.0), between(random, -half_m + 1.0, half_m - 1.0)};
        if (ground.bentDistance_m(at_m) < ground.foot_m(faces - 1) + 14.0 || !trunks.isClear(at_m, 3.0) ||
            !isFarFrom(ground.starts(), at_m, open_radius_m + 3.0))
            return std::nullopt;
        return makeTree(random, world.terrain, at_m);
    });
}

} // namespace

World makeQuarry(std::uint64_t seed) {
    const QuarryGround ground(seed);
    World world;
    world.name = "quarry";
    world.terrain =
        terrainOf({.columns = posts, .rows = posts, .step_m = 2.0 * half_m / static_cast<double>(posts - 1)},
                  [&](const Vec2& at_m) { return ground.height_m(at_m); });
    world.water = Water{.surface_z_m = wholeMillimetres(ground.waterZ_m())};
    addStarts(world, ground.starts());
    RockBuilder rocks(world, ground, seed);
    rocks.build();
    plantTrees(world, ground, seed);
    return world;
}

} // namespace usar::sim
