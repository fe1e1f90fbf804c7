#include "core/mapping/cell_floors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace usar::mapping {

namespace {

constexpr float floor_gap_m = 0.5f; ///< Hits that are farther from the mean of a floor are on another one.
constexpr float edge_m = 1.0f;      ///< A neighbor that is so much lower makes a cell an edge.
constexpr double near_m = 0.1;      ///< At this distance from the center a vote counts half.
constexpr float flat_weight = 0.02f;
/// How much more a vertical beam to the lower floor counts than a vote for the higher one.
constexpr float down_weight = 10.0f;
constexpr std::int32_t reach = 2; ///< Cells so near to each side are neighbors.
constexpr std::int32_t window_side = HeightTile::side + 2 * reach;

float square(float value) {
    return value * value;
}

std::size_t offsetOf(std::int32_t column, std::int32_t row) {
    return static_cast<std::size_t>(row * HeightTile::side + column);
}

} // namespace

struct CellFloors::Window {
    std::vector<float> low_m, high_m; ///< NaN: unknown
};

void CellFloors::Floor::take(const Floor& other) {
    if (!(other.weight > 0.0f))
        return;
    weight += other.weight;
    mean_m += (other.mean_m - mean_m) * (other.weight / weight);
    before += other.before;
    after += other.after;
}

CellFloors::Tile& CellFloors::tileFor(GridIndex tile_index) {
    if (last_.second && last_.first == tile_index)
        return *last_.second;
    std::unique_ptr<Tile>& tile = tiles_[tile_index];
    if (!tile)
        tile = std::make_unique<Tile>();
    last_ = {tile_index, tile.get()};
    return *tile;
}

void CellFloors::add(const Vec3& scanner_m, const Vec3& hit_m) {
    const Vec3 ray_m = hit_m - scanner_m;
    const Vec2 place = hit_m.head<2>() / cell_size_m_;
    // The length is not above 0 for NaN, and the place is too large for infinity.
    if (!(ray_m.squaredNorm() > 0.0 && std::isfinite(hit_m.z()) && place.cwiseAbs().maxCoeff() < double(1 << 30)))
        return;
    const Vec2 cell = place.array().floor().matrix();
    const GridIndex index{static_cast<std::int32_t>(cell.x()), static_cast<std::int32_t>(cell.y())};
    const Vec2 from_center_m = (place - cell - Vec2::Constant(0.5)) * cell_size_m_;
    const auto near = static_cast<float>(1.0 / (1.0 + from_center_m.squaredNorm() / (near_m * near_m)));
    const auto steepness = static_cast<float>(std::max(0.0, -ray_m.z() / ray_m.norm()));
    const float vote = near * steepness;
    const bool passed = from_center_m.dot(ray_m.head<2>()) >= 0.0;
    const auto z_m = static_cast<float>(hit_m.z());
    const Floor hit{z_m, steepness + flat_weight, passed ? 0.0f : vote, passed ? vote : 0.0f};
    const float down = near * square(square(steepness));

    constexpr std::int32_t side = HeightTile::side;
    const auto tileOf = [](std::int32_t at) { return (at >= 0 ? at : at - side + 1) / side; };
    const GridIndex tile{tileOf(index.column), tileOf(index.row)};
    Cell& known = tileFor(tile)[offsetOf(index.column - tile.column * side, index.row - tile.row * side)];
    if (known.low.weight > 0.0f && z_m > known.low.mean_m + floor_gap_m)
        return known.high.take(hit);
    if (known.low.weight > 0.0f && z_m < known.low.mean_m - floor_gap_m) {
        known.high.take(std::exchange(known.low, {}));
        known.down = 0.0f;
    }
    known.low.take(hit);
    known.down += down;
}

CellFloors::Window CellFloors::windowAround(GridIndex tile_index, const HeightMap& map) const {
    constexpr std::int32_t side = HeightTile::side;
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    Window window{std::vector<float>(window_side * window_side, unknown), {}};
    window.high_m = window.low_m;
    for (std::int32_t d_row = -1; d_row <= 1; ++d_row)
        for (std::int32_t d_column = -1; d_column <= 1; ++d_column) {
            const GridIndex index{tile_index.column + d_column, tile_index.row + d_row};
            const auto found = tiles_.find(index);
            const Tile* const floors = found == tiles_.end() ? nullptr : found->second.get();
            const HeightTile* const heights = map.tile(index);
            const auto first = [](std::int32_t d) { return d < 0 ? side - reach : 0; };
            const auto last = [](std::int32_t d) { return d > 0 ? reach : side; };
            for (std::int32_t row = first(d_row); row < last(d_row); ++row)
                for (std::int32_t column = first(d_column); column < last(d_column); ++column) {
                    const std::size_t from = offsetOf(column, row);
                    const auto to = static_cast<std::size_t>((row + d_row * side + reach) * window_side + column +
                                                             d_column * side + reach);
                    if (floors && (*floors)[from].low.weight > 0.0f) {
                        const Cell& cell = (*floors)[from];
                        window.low_m[to] = cell.low.mean_m;
                        window.high_m[to] = cell.high.weight > 0.0f ? cell.high.mean_m : cell.low.mean_m;
                    } else if (heights) {
                        window.low_m[to] = window.high_m[to] = heights->height_m[from];
                    }
                }
        }
    return window;
}

/// `at` is the place of the cell in the window.
float CellFloors::height_m(const Cell& cell, const Window& window, std::size_t at) {
    const auto aroundIt = [at](auto&& look) {
        for (std::int32_t row = -reach; row <= reach; ++row)
            for (std::int32_t column = -reach; column <= reach; ++column)
                if (row != 0 || column != 0)
                    look(at + static_cast<std::size_t>(row * window_side + column));
    };
    const bool two = cell.high.weight > 0.0f;
    const Floor& high = two ? cell.high : cell.low;
    float low_m = cell.low.mean_m;
    if (!two) {
        aroundIt([&](std::size_t near) { low_m = std::min(low_m, window.low_m[near]); }); // It keeps low_m if NaN.
        if (low_m > cell.low.mean_m - edge_m)
            return cell.low.mean_m;
    }
    const float middle_m = (low_m + high.mean_m) / 2.0f;
    float known = 0.0f, as_high = 0.0f;
    aroundIt([&](std::size_t near) {
        known += std::isnan(window.high_m[near]) ? 0.0f : 1.0f;
        as_high += window.high_m[near] > middle_m ? 1.0f : 0.0f;
    });
    const float odds = square((as_high + 0.5f) / (known - as_high + 0.5f));
    const float covered = odds * high.before, open = two ? down_weight * cell.down : high.after;
    if (!(covered + open > 0.0f)) // All beams were flat.
        return high.mean_m;
    return low_m + (high.mean_m - low_m) * covered / (covered + open);
}

void CellFloors::settle(HeightMap& map) const {
    constexpr std::int32_t side = HeightTile::side;
    std::vector<std::pair<GridIndex, float>> settled; // They are written at the end, because windows read filled cells.
    for (const auto& [index, tile] : tiles_) {
        const HeightTile* const heights = map.tile(index);
        const Window window = windowAround(index, map);
        for (std::int32_t row = 0; heights && row < side; ++row)
            for (std::int32_t column = 0; column < side; ++column) {
                const std::size_t offset = offsetOf(column, row);
                Cell cell = (*tile)[offset];
                if (std::isnan(heights->height_m[offset]))
                    continue;
                if (heights->hits[offset] == 0) // Whatever it is filled with ends at the center as likely as not.
                    cell = {.low = {heights->height_m[offset], 1.0f, 1.0f, 1.0f}, .high = {}};
                const auto at = static_cast<std::size_t>((row + reach) * window_side + column + reach);
                if (cell.low.weight > 0.0f)
                    settled.emplace_back(GridIndex{index.column * side + column, index.row * side + row},
                                         height_m(cell, window, at));
            }
    }
    for (const auto& [cell, height_m] : settled)
        map.settle(cell, height_m);
}

} // namespace usar::mapping
