#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/mapping/relief/relief_surface.h"

namespace usar::mapping {

namespace {

constexpr int relief_tile_side = HeightTile::side;

using TileList = std::vector<const ReliefTile*>;

std::int64_t tilesApart(GridIndex a, GridIndex b) {
    return std::max(std::abs(std::int64_t(a.column) - b.column), std::abs(std::int64_t(a.row) - b.row));
}

/// The tiles that may be in one raster with the one nearest to the median; at least that one, unless there are none.
TileList tilesTogether(const ReliefSurface& surface) {
    const auto middle_of = [&surface](std::int32_t GridIndex::*part) {
        std::vector<std::int32_t> values;
        for (const auto& [index, tile] : surface.tiles)
            values.push_back(index.*part);
        const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), half, values.end());
        return *half;
    };
    TileList together;
    if (surface.tiles.empty())
        return together;
    const GridIndex median{middle_of(&GridIndex::column), middle_of(&GridIndex::row)};
    const GridIndex center = std::ranges::min_element(surface.tiles, {}, [median](const auto& entry) {
                                 return tilesApart(entry.first, median);
                             })->first;
    for (const auto& [index, tile] : surface.tiles)
        if (tilesApart(index, center) <= maximum_raster_side / relief_tile_side)
            together.push_back(tile.get());
    return together;
}

/// Tiles of which each adjoins another one, at least with a corner.
struct TileGroup {
    TileList tiles{};
    CellBounds bounds{}; ///< in tiles
    std::int64_t known_cells = 0;

    void add(const ReliefTile* tile) {
        std::optional<CellBounds> all = tiles.empty() ? std::nullopt : std::optional(bounds);
        CellBounds::include(all, tile->index);
        bounds = *all;
        tiles.push_back(tile);
        known_cells += tile->known_cells;
    }
    std::int64_t length() const { return std::max(bounds.columns(), bounds.rows()); }
    /// How many tiles there are between the two; 0 where they overlap.
    std::int64_t gapTo(const TileGroup& other) const {
        const auto gap = [&](std::int32_t GridIndex::*part) {
            return std::max(std::int64_t(other.bounds.first.*part) - bounds.last.*part,
                            std::int64_t(bounds.first.*part) - other.bounds.last.*part) -
                   1;
        };
        return std::max({gap(&GridIndex::column), gap(&GridIndex::row), std::int64_t(0)});
    }
    bool touches(const Rectangle& area_in_map, double tile_side_m) const {
        return std::ranges::any_of(tiles, [&](const ReliefTile* tile) {
            const Vec2 low_m(tile->index.column * tile_side_m, tile->index.row * tile_side_m);
            const Vec2 high_m(low_m + Vec2(tile_side_m, tile_side_m));
            return !area_in_map.empty() && (low_m.array() < area_in_map.max_m.array()).all() &&
                   (high_m.array() > area_in_map.min_m.array()).all();
        });
    }
};

std::vector<TileGroup> groupsOf(const TileList& tiles) {
    std::map<GridIndex, const ReliefTile*> left;
    for (const ReliefTile* const tile : tiles)
        left[tile->index] = tile;
    std::vector<TileGroup> groups;
    while (!left.empty()) {
        TileGroup& group = groups.emplace_back();
        TileList next{left.begin()->second};
        left.erase(left.begin());
        while (!next.empty()) {
            const ReliefTile* const tile = next.back();
            next.pop_back();
            group.add(tile);
            for (int d_row = -1; d_row <= 1; ++d_row)
                for (int d_column = -1; d_column <= 1; ++d_column)
                    if (const auto near = left.find({tile->index.column + d_column, tile->index.row + d_row});
                        near != left.end()) {
                        next.push_back(near->second);
                        left.erase(near);
                    }
        }
    }
    return groups;
}

/// The place of a corner, which is counted from the tile's lowest x and y in cells.
Vec2 cornerPlace(const ReliefTile& tile, int column, int row, double cell_size_m) {
    return cell_size_m *
           Vec2(tile.index.column * double(relief_tile_side) + column, tile.index.row * double(relief_tile_side) + row);
}

} // namespace

std::vector<const ReliefTile*> tilesToShow(const ReliefSurface& surface, std::span<const Rectangle> areas_in_map) {
    const std::vector<TileGroup> groups = groupsOf(tilesTogether(surface));
    TileList shown;
    if (groups.empty())
        return shown;
    const TileGroup& largest = *std::ranges::max_element(groups, {}, &TileGroup::known_cells);
    const double tile_side_m = relief_tile_side * surface.cell_size_m;
    for (const TileGroup& group : groups)
        if (group.gapTo(largest) <= largest.length() || 4 * group.known_cells >= largest.known_cells ||
            std::ranges::any_of(areas_in_map, [&](const Rectangle& area) { return group.touches(area, tile_side_m); }))
            shown.insert(shown.end(), group.tiles.begin(), group.tiles.end());
    return shown;
}

std::vector<Vec3> someCorners(std::span<const ReliefTile* const> tiles, double cell_size_m) {
    // A large map has enough of them with fewer in each tile.
    constexpr std::size_t enough = 100000;
    int step = 4;
    const auto countWith = [&tiles](int a_step) {
        const auto along = static_cast<std::size_t>(relief_tile_side / a_step) + 1;
        return tiles.size() * along * along;
    };
    while (step < relief_tile_side && countWith(step) > enough)
        step *= 2;
    std::vector<Vec3> corners;
    for (const ReliefTile* const tile : tiles)
        for (int row = 0; row <= relief_tile_side; row += step)
            for (int column = 0; column <= relief_tile_side; column += step) {
                const float height_m =
                    tile->levels[0].corners_m[static_cast<std::size_t>(row * (relief_tile_side + 1) + column)];
                if (std::isnan(height_m))
                    continue;
                const Vec2 place_m = cornerPlace(*tile, column, row, cell_size_m);
                corners.emplace_back(place_m.x(), place_m.y(), double(height_m));
            }
    if (corners.empty()) // Single cells may lie between all of these.
        for (const ReliefTile* const tile : tiles) {
            const CellBounds& known = tile->known;
            corners.emplace_back(cell_size_m * known.first.column, cell_size_m * known.first.row,
                                 double(tile->range.minimum_m));
            corners.emplace_back(cell_size_m * (known.last.column + 1.0), cell_size_m * (known.last.row + 1.0),
                                 double(tile->range.maximum_m));
        }
    return corners;
}

Rectangle boundsOf(std::span<const ReliefTile* const> tiles, double cell_size_m) {
    std::optional<CellBounds> known;
    for (const ReliefTile* const tile : tiles) {
        CellBounds::include(known, tile->known.first);
        CellBounds::include(known, tile->known.last);
    }
    return !known ? Rectangle{}
                  : Rectangle{cell_size_m * Vec2(known->first.column, known->first.row),
                              cell_size_m * Vec2(known->last.column + 1.0, known->last.row + 1.0)};
}

} // namespace usar::mapping
