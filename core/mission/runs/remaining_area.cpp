#include "core/mission/runs/remaining_area.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/mapping/area_cells.h"

namespace usar::mission {

namespace {

/// The cells of an area, of which the unknown ones are taken out gap by gap.
class UnknownCells {
public:
    UnknownCells(const mapping::AreaCells& cells, const mapping::HeightTiles& tiles)
        : cells_(cells)
        , unknown_(static_cast<std::size_t>(cells.count()), true) {
        for (const auto& [index, tile] : tiles)
            strike(*tile);
    }

    /// Bounds of all gaps with at least this many cells.
    std::optional<mapping::CellBounds> boundsOfGaps(std::int64_t least_cells) {
        std::optional<mapping::CellBounds> all;
        for (std::int64_t row = 0; row < cells_.rows.count(); ++row)
            for (std::int64_t column = 0; column < cells_.columns.count(); ++column) {
                const Gap gap = takeGap(column, row);
                if (gap.cells < least_cells || !gap.bounds)
                    continue;
                mapping::CellBounds::include(all, gap.bounds->first);
                mapping::CellBounds::include(all, gap.bounds->last);
            }
        return all;
    }

private:
    struct Gap {
        std::int64_t cells = 0;
        std::optional<mapping::CellBounds> bounds{};
    };
    struct Place {
        std::int64_t column = 0, row = 0; ///< from the first cell of the area
    };

    std::size_t at(std::int64_t column, std::int64_t row) const {
        return static_cast<std::size_t>(row * cells_.columns.count() + column);
    }

    /// Makes the known cells of the tile known.
    void strike(const mapping::HeightTile& tile) {
        constexpr std::int64_t side = mapping::HeightTile::side;
        const std::int64_t first_column = tile.index.column * side;
        const std::int64_t first_row = tile.index.row * side;
        for (std::int64_t row = std::max(cells_.rows.first, first_row);
             row <= std::min(cells_.rows.last, first_row + side - 1); ++row)
            for (std::int64_t column = std::max(cells_.columns.first, first_column);
                 column <= std::min(cells_.columns.last, first_column + side - 1); ++column)
                if (!std::isnan(
                        tile.height_m[static_cast<std::size_t>((row - first_row) * side + column - first_column)]))
                    unknown_[at(column - cells_.columns.first, row - cells_.rows.first)] = false;
    }

    /// Takes out the gap that this cell belongs to.
    Gap takeGap(std::int64_t column, std::int64_t row) {
        Gap gap;
        take(column, row);
        while (!open_.empty()) {
            const Place place = open_.back();
            open_.pop_back();
            ++gap.cells;
            mapping::CellBounds::include(gap.bounds, {static_cast<std::int32_t>(cells_.columns.first + place.column),
                                                      static_cast<std::int32_t>(cells_.rows.first + place.row)});
            take(place.column - 1, place.row);
            take(place.column + 1, place.row);
            take(place.column, place.row - 1);
            take(place.column, place.row + 1);
        }
        return gap;
    }

    void take(std::int64_t column, std::int64_t row) {
        if (column < 0 || row < 0 || column >= cells_.columns.count() || row >= cells_.rows.count() ||
            !unknown_[at(column, row)])
            return;
        unknown_[at(column, row)] = false;
        open_.push_back({column, row});
    }

    mapping::AreaCells cells_;
    std::vector<bool> unknown_;
    std::vector<Place> open_; ///< cells of the gap whose neighbors have not been looked at
};

/// The interval of a side, extended to the area's border where it reaches the outermost cell.
void fitSide(double& low_m, double& high_m, std::int64_t first, std::int64_t last, const mapping::CellSpan& all,
             double cell_size_m) {
    const double area_low_m = low_m;
    const double area_high_m = high_m;
    if (first > all.first)
        low_m = std::max(area_low_m, double(first) * cell_size_m);
    if (last < all.last)
        high_m = std::min(area_high_m, double(last + 1) * cell_size_m);
}

} // namespace

Rectangle remainingArea(const Rectangle& area_in_map, const mapping::HeightTiles& tiles, double cell_size_m,
                        double largest_gap_m2) {
    const mapping::AreaCells cells = mapping::cellsOf(area_in_map, cell_size_m);
    if (area_in_map.empty() || cells.count() == 0)
        return {};
    const auto most_cells = static_cast<std::int64_t>(largest_gap_m2 / (cell_size_m * cell_size_m) + 1e-9);
    const auto bounds = UnknownCells(cells, tiles).boundsOfGaps(most_cells + 1);
    if (!bounds)
        return {};
    Rectangle rest = area_in_map;
    fitSide(rest.min_m.x(), rest.max_m.x(), bounds->first.column, bounds->last.column, cells.columns, cell_size_m);
    fitSide(rest.min_m.y(), rest.max_m.y(), bounds->first.row, bounds->last.row, cells.rows, cell_size_m);
    return rest;
}

} // namespace usar::mission
