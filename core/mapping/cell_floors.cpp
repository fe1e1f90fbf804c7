#include "core/mapping/cell_floors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace usar::mapping {

namespace {

constexpr float floor_gap_m = 0.5f; ///< Hits that are farther from the mean of a floor are on another one.
constexpr float edge_m = 1.0f;      ///< A thing is so much higher than what is near it.
constexpr float flat_weight = 0.02f;
/// Crowns are widest where they begin, so their outline is at the lowest hits on them; but hits on what is lower than
/// this share of their height may be on trunks or bushes below.
constexpr float least_share = 0.4f;
constexpr float outline_above_m = 0.1f; ///< above the lowest hits, for what is left of the drift
/// A hit belongs to the ground if it is lower than the outline by this, or by half of the way down to the ground if
/// that is less.
constexpr float below_outline_m = 1.0f;
constexpr double bell_cells = 0.6; ///< standard deviation of the weights of neighbors
/// A cell is half covered whose share is this. It is more than a half, because a crown on open ground is a greater
/// error to whoever wants to know the ground than ground in a crown.
constexpr double middle_share = 0.8;
constexpr double share_width = 0.4; ///< Shares in between give heights in between.
/// A cell that nothing has hit is on the thing, or on the ground, only if its share is beyond these.
constexpr double surely_open = 0.6;
/// Where all points are covered, rounding makes the share 1 or a little less.
constexpr double surely_covered = 1.0 - 1e-6;
/// And only if so much of the weights of its neighbors is on that side: that of a cell beside it and the two at the
/// corners there, as along a straight edge, is 0.37. With 0.30, tall_test would be covered by another 0.3 points, and
/// its error would be greater by another 0.011 m.
constexpr double side_weight = 0.35;
/// Hits that are so much higher than the lowest ones nearby are not on the ground but on the thing, below its outline.
constexpr float same_ground_m = 0.5f;
constexpr std::int32_t reach = 2; ///< Cells so near to each side are neighbors.
constexpr std::int32_t near_side = 2 * reach + 1;
constexpr std::int32_t window_side = HeightTile::side + 2 * reach;

std::size_t offsetOf(std::int32_t column, std::int32_t row) {
    return static_cast<std::size_t>(row * HeightTile::side + column);
}

/// Weights of the neighbors of a cell, row by row.
std::array<double, near_side * near_side> makeBell() {
    std::array<double, near_side * near_side> bell{};
    for (std::int32_t row = -reach; row <= reach; ++row)
        for (std::int32_t column = -reach; column <= reach; ++column)
            bell[static_cast<std::size_t>((row + reach) * near_side + column + reach)] =
                std::exp(-(row * row + column * column) / (2.0 * bell_cells * bell_cells));
    return bell;
}

/// For each place of a window that is `reach` or more from its sides, the one of the values near it that `better`
/// prefers; NaN is never preferred to a number. Looks along rows and then along columns.
template <class Better>
std::vector<float> bestNear(const std::vector<float>& values, Better better) {
    std::vector<float> along(values.size()), best(values.size());
    const auto choose = [&](const std::vector<float>& from, std::size_t at, std::size_t stride) {
        float chosen = from[at - reach * stride];
        for (std::size_t k = 1; k < near_side; ++k) {
            const float other = from[at - reach * stride + k * stride];
            chosen = better(other, chosen) || std::isnan(chosen) ? other : chosen;
        }
        return chosen;
    };
    for (std::size_t at = reach; at + reach < values.size(); ++at) // Those that span two rows are not asked for.
        along[at] = choose(values, at, 1);
    constexpr auto margin = static_cast<std::size_t>(reach * window_side);
    for (std::size_t at = margin; at + margin < values.size(); ++at)
        best[at] = choose(along, at, window_side);
    return best;
}

} // namespace

struct CellFloors::Window {
    std::vector<float> low_m, high_m; ///< NaN: unknown
    std::vector<float> lowest_m;      ///< hits of the higher floor
    std::vector<float> ground_near_m; ///< the lowest of the low floors near each place
    std::vector<float> top_near_m;    ///< and the highest of the high ones

    /// Calls `take` with the place in the window of each neighbor of a cell and of the cell itself, and with its
    /// weight.
    template <class Take>
    static void eachNear(std::size_t at, Take&& take) {
        static const auto bell = makeBell();
        const double* weight = bell.data();
        for (std::int32_t row = -reach; row <= reach; ++row)
            for (std::int32_t column = -reach; column <= reach; ++column)
                take(at + static_cast<std::size_t>(row * window_side + column), *weight++);
    }
    static std::size_t placeOf(std::int32_t column, std::int32_t row) {
        return static_cast<std::size_t>((row + reach) * window_side + column + reach);
    }
    std::optional<EdgeLooks::Edge> edgeAt(std::size_t at) const;
    Sides sidesAt(std::size_t at, const EdgeLooks::Edge& edge) const;
};

/// The edge that may be at this place: something near is well above what is lowest near.
std::optional<EdgeLooks::Edge> CellFloors::Window::edgeAt(std::size_t at) const {
    const float ground_m = ground_near_m[at], top_m = top_near_m[at];
    if (!(top_m > ground_m + edge_m))
        return std::nullopt;
    float outline_m = top_m;
    eachNear(at, [&](std::size_t near, double) {
        if (lowest_m[near] > ground_m + least_share * (top_m - ground_m))
            outline_m = std::min(outline_m, lowest_m[near]);
    });
    outline_m += outline_above_m;
    return EdgeLooks::Edge{outline_m, outline_m - std::min(below_outline_m, (outline_m - ground_m) / 2.0f)};
}

CellFloors::Sides CellFloors::Window::sidesAt(std::size_t at, const EdgeLooks::Edge& edge) const {
    float lowest = edge.least_m;
    eachNear(at, [&](std::size_t near, double) { lowest = std::fmin(lowest, low_m[near]); });
    const float ground_below_m = std::min(edge.least_m, lowest + same_ground_m);
    Sides sides;
    eachNear(at, [&](std::size_t near, double weight) {
        if (low_m[near] < ground_below_m) {
            sides.ground_m += weight * double(low_m[near]);
            sides.grounds += weight;
        }
        if (high_m[near] >= edge.least_m) {
            sides.thing_m += weight * double(high_m[near]);
            sides.things += weight;
        }
    });
    sides.ground_m /= sides.grounds;
    sides.thing_m /= sides.things;
    return sides;
}

void CellFloors::Floor::take(const Floor& other) {
    if (!(other.weight > 0.0f))
        return;
    lowest_m = weight > 0.0f ? std::min(lowest_m, other.lowest_m) : other.lowest_m;
    weight += other.weight;
    mean_m += (other.mean_m - mean_m) * (other.weight / weight);
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
    const auto steepness = static_cast<float>(std::max(0.0, -ray_m.z() / ray_m.norm()));
    const auto z_m = static_cast<float>(hit_m.z());
    const Floor hit{z_m, steepness + flat_weight, z_m};

    constexpr std::int32_t side = HeightTile::side;
    const auto tileOf = [](std::int32_t at) { return (at >= 0 ? at : at - side + 1) / side; };
    const GridIndex tile{tileOf(index.column), tileOf(index.row)};
    Cell& known = tileFor(tile)[offsetOf(index.column - tile.column * side, index.row - tile.row * side)];
    if (known.low.weight > 0.0f && z_m > known.low.mean_m + floor_gap_m)
        return known.high.take(hit);
    if (known.low.weight > 0.0f && z_m < known.low.mean_m - floor_gap_m)
        known.high.take(std::exchange(known.low, {}));
    known.low.take(hit);
}

CellFloors::Window CellFloors::windowAround(GridIndex tile_index, const HeightMap& map) const {
    constexpr std::int32_t side = HeightTile::side;
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    Window window{std::vector<float>(window_side * window_side, unknown), {}, {}, {}, {}};
    window.high_m = window.lowest_m = window.low_m;
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
                        const Floor& high = cell.high.weight > 0.0f ? cell.high : cell.low;
                        window.high_m[to] = high.mean_m;
                        window.lowest_m[to] = high.lowest_m;
                    } else if (heights) {
                        window.low_m[to] = window.high_m[to] = heights->height_m[from];
                    }
                }
        }
    window.ground_near_m = bestNear(window.low_m, std::less<float>());
    window.top_near_m = bestNear(window.high_m, std::greater<float>());
    return window;
}

void CellFloors::findEdges(const HeightMap& map) {
    constexpr std::int32_t side = HeightTile::side;
    for (const auto& [index, tile] : tiles_) {
        const Window window = windowAround(index, map);
        for (std::int32_t row = 0; row < side; ++row)
            for (std::int32_t column = 0; column < side; ++column)
                if (const auto edge = window.edgeAt(Window::placeOf(column, row)))
                    looks_.addEdge({index.column * side + column, index.row * side + row}, *edge);
    }
}

float CellFloors::height_m(const Cell& cell, std::optional<double> share, const Window& window, std::size_t at) {
    const bool two = cell.high.weight > 0.0f;
    const auto edge = share ? window.edgeAt(at) : std::nullopt;
    if (!edge)
        return two && cell.high.weight > cell.low.weight ? cell.high.mean_m : cell.low.mean_m;
    const Sides sides = window.sidesAt(at, *edge);
    const Floor& high = two ? cell.high : cell.low;
    const double low_m =
        cell.low.mean_m < edge->least_m || !(sides.grounds > 0.0) ? double(cell.low.mean_m) : sides.ground_m;
    const double high_m = high.mean_m >= edge->least_m || !(sides.things > 0.0) ? double(high.mean_m) : sides.thing_m;
    const double covered = std::clamp((*share - middle_share) / share_width + 0.5, 0.0, 1.0);
    return static_cast<float>(low_m + covered * (high_m - low_m));
}

std::optional<float> CellFloors::unhitHeight_m(double share, const Window& window, std::size_t at) {
    const auto edge = window.edgeAt(at);
    if (!edge || (share > surely_open && share < surely_covered))
        return std::nullopt;
    const Sides sides = window.sidesAt(at, *edge);
    const bool open = share <= surely_open;
    if ((open ? sides.grounds : sides.things) < side_weight)
        return std::nullopt;
    return static_cast<float>(open ? sides.ground_m : sides.thing_m);
}

void CellFloors::settle(HeightMap& map) const {
    constexpr std::int32_t side = HeightTile::side;
    std::vector<std::pair<GridIndex, float>> settled; // They are written at the end, because windows read filled cells.
    std::vector<std::pair<GridIndex, float>> filled;
    for (const auto& [index, tile] : tiles_) {
        const HeightTile* const heights = map.tile(index);
        const Window window = windowAround(index, map);
        for (std::int32_t row = 0; heights && row < side; ++row)
            for (std::int32_t column = 0; column < side; ++column) {
                const std::size_t offset = offsetOf(column, row);
                const GridIndex at{index.column * side + column, index.row * side + row};
                const std::size_t place = Window::placeOf(column, row);
                const auto share = looks_.coveredShare(at);
                Cell cell = (*tile)[offset];
                if (std::isnan(heights->height_m[offset])) {
                    if (const auto unhit_m = share ? unhitHeight_m(*share, window, place) : std::nullopt)
                        filled.emplace_back(at, *unhit_m);
                    continue;
                }
                if (heights->hits[offset] == 0)
                    cell = {.low = {heights->height_m[offset], 1.0f, heights->height_m[offset]}, .high = {}};
                if (cell.low.weight > 0.0f)
                    settled.emplace_back(at, height_m(cell, share, window, place));
            }
    }
    for (const auto& [cell, height_m] : settled)
        map.settle(cell, height_m);
    for (const auto& [cell, height_m] : filled)
        map.fill(cell, height_m, {}); // No single scan tells it.
}

} // namespace usar::mapping
