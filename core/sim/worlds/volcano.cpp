#include "core/sim/worlds/made_worlds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/numbers.h"
#include "core/sim/worlds/building.h"
#include "core/sim/worlds/fractal_noise.h"

namespace usar::sim {

namespace {

bool appendRow(std::string_view line, std::vector<double>& heights_m) {
    for (;;) {
        const std::size_t comma = line.find(',');
        const auto height_m = readNumber(line.substr(0, comma));
        if (!height_m || !std::isfinite(*height_m))
            return false;
        heights_m.push_back(*height_m);
        if (comma == std::string_view::npos)
            return true;
        line.remove_prefix(comma + 1);
    }
}

constexpr int trees = 300;
constexpr std::size_t posts_between = 20; ///< steps of ours from one post of the source to the next
constexpr double open_radius_m = 10.0;
constexpr GpsReference maunga_whau{-36.8764, 174.7647}; ///< near the crater

/// Weights of four posts for a Catmull-Rom spline at `t` in 0..1 between the middle two, with the slopes of their
/// neighbors.
std::array<double, 4> splineWeights(double t) {
    return {0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (3.0 * t - 5.0),
            0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

/// The source's surface plus our noise.
class VolcanoGround {
public:
    VolcanoGround(const ElevationTable& source, std::uint64_t seed)
        : source_(source)
        , roughness_{.seed = seeded(seed, 3)(), .octaves = 4, .wavelength_m = volcano_post_m, .amplitude_m = 0.2}
        , half_m_(volcano_post_m * Vec2(static_cast<double>(source.rows - 1), static_cast<double>(source.columns - 1)) /
                  2.0) {
        chooseStarts();
    }

    double height_m(const Vec2& at_m) const {
        double calm = 1.0;
        for (const StartPlace& start : starts_)
            calm = std::min(calm, smoothStep(2.5, open_radius_m, (at_m - start.at_m).norm()));
        return spline_m(at_m) + calm * roughness_.at(at_m + half_m_);
    }
    const std::vector<StartPlace>& starts() const { return starts_; }
    const Vec2& half_m() const { return half_m_; }

private:
    double spline_m(const Vec2& at_m) const {
        const Vec2 post = ((at_m + half_m_) / volcano_post_m).cwiseMax(0.0);
        const auto cellOf = [](double coordinate, std::size_t count) {
            return std::min(static_cast<std::size_t>(coordinate), count - 2);
        };
        const std::size_t row = cellOf(post.x(), source_.rows);
        const std::size_t column = cellOf(post.y(), source_.columns);
        const auto along_rows = splineWeights(post.x() - static_cast<double>(row));
        const auto along_columns = splineWeights(post.y() - static_cast<double>(column));
        // Beyond the border, the posts on it are repeated.
        const auto neighbor = [](std::size_t cell, std::size_t i, std::size_t count) {
            return std::min(cell + i - std::min<std::size_t>(cell + i, 1), count - 1);
        };
        double height_m = 0.0;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                height_m += along_rows[i] * along_columns[j] *
                            source_.at(neighbor(row, i, source_.rows), neighbor(column, j, source_.columns));
        return height_m;
    }

    StartPlace levelNear(const char* name, const Vec2& hint_m, double reach_m) const {
        const Vec2 best_m = bestOnGrid(reach_m, 2.5, [&](const Vec2& offset_m) -> std::optional<double> {
            double unevenness_m = 0.0;
            for (const Vec2& side_m : ringAround(hint_m + offset_m, 2.0))
                unevenness_m = std::max(unevenness_m, std::abs(spline_m(side_m) - spline_m(hint_m + offset_m)));
            return -unevenness_m - 1e-4 * offset_m.norm();
        });
        const Vec2 at_m = hint_m + best_m;
        return {name, at_m, yawToward(at_m, Vec2::Zero())};
    }

    void chooseStarts() {
        starts_ = {levelNear("PlayerStart", {185.0, -90.0}, 20.0), levelNear("Summit", {-240.0, 0.0}, 40.0),
                   levelNear("CraterFloor", {-135.0, 30.0}, 30.0), levelNear("NorthFoot", {330.0, 215.0}, 20.0)};
    }

    const ElevationTable& source_;
    FractalNoise roughness_;
    Vec2 half_m_;
    std::vector<StartPlace> starts_;
};

void plantTrees(World& world, const VolcanoGround& ground, std::uint64_t seed) {
    Random random = seeded(seed, 4);
    const FractalNoise woods{.seed = random(), .octaves = 2, .wavelength_m = 120.0, .amplitude_m = 1.0};
    Spacing trunks(ground.half_m().maxCoeff());
    const Vec2 reach_m = ground.half_m() - Vec2::Constant(5.0);
    scatter(world, trunks, trees, 1000 * trees, [&]() -> std::optional<Plant> {
        const Vec2 at_m(between(random, -reach_m.x(), reach_m.x()), between(random, -reach_m.y(), reach_m.y()));
        const bool grows = uniform(random, 0.0, 1.0) < smoothStep(0.0, 0.6, woods.at(at_m));
        if (!grows || !isFarFrom(ground.starts(), at_m, open_radius_m + 3.0) || !trunks.isClear(at_m, 3.0))
            return std::nullopt;
        return makeTree(random, world.terrain, at_m);
    });
}

} // namespace

Result<ElevationTable> readElevationCsv(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return failure("the heights cannot be opened", file.string(), "Check the file's name and its permissions");
    ElevationTable table;
    std::string line;
    while (std::getline(in, line)) {
        const std::string where = file.string() + ":" + std::to_string(table.rows + 1);
        const std::size_t before = table.heights_m.size();
        if (!appendRow(line, table.heights_m))
            return failure("one of the values is not a height", where, "Give numbers with commas between them");
        const std::size_t columns = table.heights_m.size() - before;
        if (table.rows > 0 && columns != table.columns)
            return failure("the line has " + std::to_string(columns) + " heights, the first one " +
                               std::to_string(table.columns),
                           where, "Give every line the same number of heights");
        table.columns = columns;
        ++table.rows;
    }
    if (table.rows < 4 || table.columns < 4)
        return failure("there are fewer than 4 x 4 heights", file.string(), "Check that the file is complete");
    return table;
}

World makeVolcano(const ElevationTable& source, std::uint64_t seed) {
    const VolcanoGround ground(source, seed);
    World world;
    world.name = "volcano";
    world.terrain = terrainOf({.columns = (source.rows - 1) * posts_between + 1,
                               .rows = (source.columns - 1) * posts_between + 1,
                               .step_m = volcano_post_m / static_cast<double>(posts_between),
                               .steps_per_m = 512.0},
                              [&](const Vec2& at_m) { return ground.height_m(at_m); });
    world.gps_reference = maunga_whau;
    addStarts(world, ground.starts());
    plantTrees(world, ground, seed);
    return world;
}

} // namespace usar::sim
