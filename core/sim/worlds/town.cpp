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

constexpr double half_m = 60.0;
constexpr std::size_t posts = 481;
constexpr double roadway_half_m = 3.0;
constexpr double mast_off_m = 4.2;    ///< from the middle of a street to the masts on its sidewalk
constexpr double street_half_m = 5.0; ///< sidewalks included
constexpr double curb_m = 0.12;
constexpr double curb_run_m = 0.7;    ///< so flat that wheels climb it
constexpr double border_m = 58.0;     ///< no block goes beyond
constexpr double lot_m = 8.2;         ///< least width of a lot
constexpr double open_radius_m = 8.0; ///< without masts and wires, around a start place
constexpr int trees = 70;

/// Where the streets are, and the ground under all. A pure function of seed and point; map frame, meters.
class TownGround {
public:
    explicit TownGround(std::uint64_t seed) {
        Random random = seeded(seed, 9);
        hills_ = {.seed = random(), .octaves = 2, .wavelength_m = 70.0, .amplitude_m = 1.2};
        for (std::size_t i = 0; i < 3; ++i) {
            const double middle_m = 38.0 * (static_cast<double>(i) - 1.0);
            streets_x_m_[i] = middle_m + between(random, -3.0, 3.0);
            streets_y_m_[i] = middle_m + between(random, -3.0, 3.0);
        }
        square_column_ = uniform(random, 0.0, 1.0) < 0.5 ? 1 : 2;
        square_row_ = uniform(random, 0.0, 1.0) < 0.5 ? 1 : 2;
        const Vec2 crossing_m(streets_x_m_[1], streets_y_m_[1]);
        const Vec2 square_m = square().center_m() + Vec2(0.0, -9.5);
        starts_ = {{"PlayerStart", crossing_m, 0.0},
                   {"Square", square_m, pi / 2.0},
                   {"NorthStreet", {50.0, streets_y_m_[1]}, pi},
                   {"WestStreet", {streets_x_m_[1], 50.0}, -pi / 2.0},
                   {"SouthLane", {(streets_x_m_[0] + streets_x_m_[1]) / 2.0, streets_y_m_[0]}, 0.0}};
        for (StartPlace& start : starts_) {
            start.at_m = start.at_m.unaryExpr(&wholeMillimetres);
            start_heights_m_.push_back(hills_.at(start.at_m) - (start.name == "Square" ? 0.0 : curb_m));
        }
    }

    double height_m(const Vec2& at_m) const {
        double height_m = hills_.at(at_m) - curb_m * (1.0 - smoothStep(roadway_half_m, roadway_half_m + curb_run_m,
                                                                       roadDistance_m(at_m)));
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            const double level = 1.0 - smoothStep(2.5, 10.0, (at_m - starts_[i].at_m).norm());
            const double above_m = height_m - hills_.at(at_m) - (starts_[i].name == "Square" ? 0.0 : -curb_m);
            height_m = std::lerp(height_m, start_heights_m_[i] + above_m, level);
        }
        return height_m;
    }

    /// Distance to the middle of the nearest street.
    double roadDistance_m(const Vec2& at_m) const {
        double nearest_m = 2.0 * half_m;
        for (std::size_t i = 0; i < 3; ++i)
            nearest_m =
                std::min({nearest_m, std::abs(at_m.x() - streets_x_m_[i]), std::abs(at_m.y() - streets_y_m_[i])});
        return nearest_m;
    }

    /// The ground between the sidewalks; columns and rows are counted from 0 to 3 along x and y.
    Rectangle blockOfHouses(std::size_t column, std::size_t row) const {
        const auto span = [](const std::array<double, 3>& streets_m, std::size_t i) {
            return Vec2(i == 0 ? -border_m : streets_m[i - 1] + street_half_m,
                        i == 3 ? border_m : streets_m[i] - street_half_m);
        };
        const Vec2 x = span(streets_x_m_, column);
        const Vec2 y = span(streets_y_m_, row);
        return {{x[0], y[0]}, {x[1], y[1]}};
    }

    bool isSquare(std::size_t column, std::size_t row) const { return column == square_column_ && row == square_row_; }
    Rectangle square() const { return blockOfHouses(square_column_, square_row_); }
    const std::array<double, 3>& streetsX_m() const { return streets_x_m_; }
    const std::array<double, 3>& streetsY_m() const { return streets_y_m_; }
    const std::vector<StartPlace>& starts() const { return starts_; }

private:
    FractalNoise hills_;
    std::array<double, 3> streets_x_m_{}; ///< x of those that run along y
    std::array<double, 3> streets_y_m_{}; ///< y of those that run along x
    std::size_t square_column_ = 1;
    std::size_t square_row_ = 1;
    std::vector<StartPlace> starts_;
    std::vector<double> start_heights_m_;
};

/// Builds houses lot by lot, and remembers what ground they cover.
class HouseBuilder {
public:
    HouseBuilder(World& world, const TownGround& ground, std::uint64_t seed)
        : world_(world)
        , ground_(ground)
        , random_(seeded(seed, 10)) {}

    void build() {
        for (std::size_t column = 0; column < 4; ++column)
            for (std::size_t row = 0; row < 4; ++row)
                if (ground_.isSquare(column, row))
                    buildSquare();
                else
                    buildBlock(ground_.blockOfHouses(column, row));
    }

    /// True if no house is within `distance_m`.
    bool isFree(const Vec2& at_m, double distance_m) const {
        return std::ranges::all_of(footprints_, [&](const Rectangle& footprint) {
            const Vec2 off_m = (footprint.min_m - at_m).cwiseMax(at_m - footprint.max_m).cwiseMax(0.0);
            return off_m.norm() > distance_m;
        });
    }

private:
    void buildBlock(const Rectangle& area) {
        const int columns = std::max(1, static_cast<int>(area.width_m() / lot_m));
        const int rows = std::max(1, static_cast<int>(area.height_m() / lot_m));
        const Vec2 size_m(area.width_m() / columns, area.height_m() / rows);
        for (int column = 0; column < columns; ++column)
            for (int row = 0; row < rows; ++row) {
                const bool yard = column > 0 && column < columns - 1 && row > 0 && row < rows - 1;
                const bool vacant = uniform(random_, 0.0, 1.0) < 0.1;
                if (!yard && !vacant)
                    buildHouse(area.min_m + size_m.cwiseProduct(Vec2(column + 0.5, row + 0.5)), size_m);
            }
    }

    void buildHouse(const Vec2& lot_center_m, const Vec2& lot_size_m) {
        const Vec2 at_m{lot_center_m.x() + between(random_, -0.2, 0.2), lot_center_m.y() + between(random_, -0.2, 0.2)};
        const Vec2 size_m{wholeMillimetres(uniform(random_, 0.65, 0.85) * lot_size_m.x()),
                          wholeMillimetres(uniform(random_, 0.65, 0.85) * lot_size_m.y())};
        const bool flat = uniform(random_, 0.0, 1.0) < 0.2;
        const double walls_m = flat ? between(random_, 6.0, 13.0) : between(random_, 3.2, 7.0);
        const double pitch_rad = between(random_, 0.5, 0.75);
        const double eaves_m = raise(at_m, size_m, walls_m);
        if (!flat)
            addRoof(at_m, size_m, eaves_m, pitch_rad);
    }

    /// Adds the walls, which stand in the ground however it slopes; returns the height of their upper edge.
    double raise(const Vec2& at_m, const Vec2& size_m, double walls_m) {
        const auto [lowest_m, highest_m] = groundUnder(world_.terrain, at_m, size_m, 0.0);
        const double floor_m = wholeMillimetres(lowest_m - 0.5);
        const double eaves_m = wholeMillimetres(highest_m + walls_m);
        world_.boxes.push_back(block({at_m.x() - size_m.x() / 2.0, at_m.y() - size_m.y() / 2.0, floor_m},
                                     {at_m.x() + size_m.x() / 2.0, at_m.y() + size_m.y() / 2.0, eaves_m}));
        footprints_.push_back({at_m - size_m / 2.0, at_m + size_m / 2.0});
        return eaves_m;
    }

    /// Two slabs from the eaves to the ridge, so thick that they fill the gable. Up to a pitch of 45 degrees neither
    /// comes out through the other.
    void addRoof(const Vec2& at_m, const Vec2& size_m, double eaves_m, double pitch_rad) {
        const bool along_x = size_m.x() > size_m.y();
        const double length_m = std::max(size_m.x(), size_m.y());
        const double half_span_m = std::min(size_m.x(), size_m.y()) / 2.0;
        const double thickness_m = wholeMillimetres(half_span_m * std::sin(pitch_rad));
        const Vec3 ridge_m(at_m.x(), at_m.y(), eaves_m + half_span_m * std::tan(pitch_rad));
        for (const double side : {-half_span_m, half_span_m}) {
            const Vec3 eaves_at_m(at_m.x() + (along_x ? 0.0 : side), at_m.y() + (along_x ? side : 0.0), eaves_m);
            world_.boxes.push_back(slab(eaves_at_m, ridge_m, length_m, thickness_m));
        }
    }

    /// A church with a tower along the west side of the square, and a fountain in front of it.
    void buildSquare() {
        const Vec2 middle_m = ground_.square().center_m();
        const Vec2 nave_m = middle_m + Vec2(-1.5, 8.5);
        const double pitch_rad = between(random_, 0.6, 0.78);
        addRoof(nave_m, {15.0, 8.0}, raise(nave_m, {15.0, 8.0}, between(random_, 6.0, 8.0)), pitch_rad);
        const Vec2 tower_m = nave_m + Vec2(9.7, 0.0);
        const double eaves_m = raise(tower_m, {4.4, 4.4}, between(random_, 15.0, 19.0));
        addRoof(tower_m, {4.4, 4.4}, eaves_m, 0.78);
        const Vec2 fountain_m = middle_m + Vec2(0.0, -1.5);
        const double rim_m = raise(fountain_m, {3.0, 3.0}, 0.6);
        Box turned = world_.boxes.back();
        turned.center_in_map.yaw_rad = pi / 4.0;
        world_.boxes.push_back(turned);
        world_.boxes.push_back(block({fountain_m.x() - 0.25, fountain_m.y() - 0.25, rim_m},
                                     {fountain_m.x() + 0.25, fountain_m.y() + 0.25, rim_m + 1.4}));
    }

    World& world_;
    const TownGround& ground_;
    Random random_;
    std::vector<Rectangle> footprints_;
};

/// Sets masts on the sidewalks and hangs wires between them.
class MastBuilder {
public:
    MastBuilder(World& world, const TownGround& ground, std::uint64_t seed)
        : world_(world)
        , ground_(ground)
        , random_(seeded(seed, 11)) {}

    void build() {
        line_street_ = uniform(random_, 0.0, 1.0) < 0.5 ? 0 : 2;
        for (std::size_t street = 0; street < 3; ++street) {
            lineStreet(ground_.streetsY_m()[street], ground_.streetsX_m(), true, street == line_street_);
            lineStreet(ground_.streetsX_m()[street], ground_.streetsY_m(), false, false);
        }
    }

    const std::vector<Vec2>& masts_m() const { return masts_m_; }

private:
    /// Masts along one street, whose middle is `middle_m` across it; `crossings_m` are positions along it. Every other
    /// place has two masts and a wire across. If the street has a line, a wire also leads from mast to mast.
    void lineStreet(double middle_m, const std::array<double, 3>& crossings_m, bool along_x, bool has_line) {
        std::optional<Vec3> last_top_m;
        bool across = uniform(random_, 0.0, 1.0) < 0.5;
        for (double along_m = -54.0; along_m < border_m; along_m += 12.0) {
            const double at = along_m + between(random_, -1.0, 1.0);
            const auto place = [&](double off_m) {
                return along_x ? Vec2(at, middle_m + off_m) : Vec2(middle_m + off_m, at);
            };
            const bool crossing =
                std::ranges::any_of(crossings_m, [&](double other_m) { return std::abs(at - other_m) < 7.0; });
            if (crossing || !isFarFrom(ground_.starts(), place(0.0), open_radius_m))
                continue;
            const Vec3 top_m = setMast(place(mast_off_m));
            if (across)
                hangWire(top_m, setMast(place(-mast_off_m)));
            across = !across;
            if (has_line && last_top_m)
                hangWire(*last_top_m, top_m);
            last_top_m = top_m;
        }
    }

    /// Returns the point where wires are fixed.
    Vec3 setMast(const Vec2& at_m) {
        Plant mast;
        mast.trunk_radius_m = 0.08;
        mast.trunk_height_m = between(random_, 7.8, 9.0);
        mast.base_in_map_m = {wholeMillimetres(at_m.x()), wholeMillimetres(at_m.y()),
                              lowestGround_m(world_.terrain, at_m, mast.trunk_radius_m)};
        world_.plants.push_back(mast);
        masts_m_.push_back(mast.base_in_map_m.head<2>());
        return mast.base_in_map_m + Vec3(0.0, 0.0, mast.trunk_height_m - 0.1);
    }

    /// A wire that sags by a fiftieth of its span.
    void hangWire(const Vec3& from_m, const Vec3& to_m) {
        const double sag_m = 0.02 * (to_m - from_m).norm();
        const auto at = [&](double share) -> Vec3 {
            return from_m + share * (to_m - from_m) - Vec3(0.0, 0.0, 4.0 * sag_m * share * (1.0 - share));
        };
        for (int piece = 0; piece < 4; ++piece)
            world_.boxes.push_back(beam(at(0.25 * piece), at(0.25 * (piece + 1)), wire_m, wire_m));
    }

    World& world_;
    const TownGround& ground_;
    Random random_;
    std::size_t line_street_ = 0; ///< the street along x that has a line
    std::vector<Vec2> masts_m_;
};

void plantTrees(World& world, const TownGround& ground, const HouseBuilder& houses, const std::vector<Vec2>& masts_m,
                std::uint64_t seed) {
    Random random = seeded(seed, 12);
    Spacing trunks(half_m);
    for (const Vec2& mast_m : masts_m)
        trunks.add(mast_m);
    scatter(world, trunks, trees, 500 * trees, [&]() -> std::optional<Plant> {
        const Vec2 at_m{between(random, -border_m, border_m), between(random, -border_m, border_m)};
        const Plant tree = makeTree(random, world.terrain, at_m);
        const double reach_m = tree.crown_radius_m;
        // Crowns stay off the wires, which hang as far out as the masts stand.
        if (ground.roadDistance_m(at_m) < mast_off_m + reach_m + 0.5 || !trunks.isClear(at_m, reach_m + 1.5) ||
            !houses.isFree(at_m, reach_m + 0.3) || !isFarFrom(ground.starts(), at_m, reach_m + 5.0))
            return std::nullopt;
        return tree;
    });
}

} // namespace

World makeTown(std::uint64_t seed) {
    const TownGround ground(seed);
    World world;
    world.name = "town";
    world.terrain =
        terrainOf({.columns = posts, .rows = posts, .step_m = 2.0 * half_m / static_cast<double>(posts - 1)},
                  [&](const Vec2& at_m) { return ground.height_m(at_m); });
    addStarts(world, ground.starts());
    HouseBuilder houses(world, ground, seed);
    houses.build();
    MastBuilder masts(world, ground, seed);
    masts.build();
    plantTrees(world, ground, houses, masts.masts_m(), seed);
    return world;
}

} // namespace usar::sim
