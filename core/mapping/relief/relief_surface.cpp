#include "core/mapping/relief/relief_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace usar::mapping {

namespace {

constexpr int relief_side = HeightTile::side;
constexpr int margin = relief_side / 2; // A corner of the coarsest level has blocks of this side around it.
constexpr int patch_side = relief_side + 2 * margin;
constexpr float no_height = std::numeric_limits<float>::quiet_NaN();

/// Heights of a square of blocks around a tile, row-major from the lowest x and y.
struct Patch {
    int columns = patch_side;
    std::vector<float> heights_m = std::vector<float>(std::size_t(patch_side) * patch_side, no_height);

    float& at(int column, int row) { return heights_m[static_cast<std::size_t>(row * columns + column)]; }
    float at(int column, int row) const { return heights_m[static_cast<std::size_t>(row * columns + column)]; }
};

/// Mean of those that are known; NaN if fewer than `least` are.
float meanOf(float a, float b, float c, float d, int least) {
    float sum = 0.0f;
    int known = 0;
    for (const float one : {a, b, c, d})
        if (!std::isnan(one)) {
            sum += one;
            ++known;
        }
    return known < least ? no_height : sum / static_cast<float>(known);
}

Patch halved(const Patch& fine) {
    Patch coarse{fine.columns / 2, {}};
    coarse.heights_m.resize(fine.heights_m.size() / 4);
    for (int row = 0; row < coarse.columns; ++row)
        for (int column = 0; column < coarse.columns; ++column)
            coarse.at(column, row) = meanOf(fine.at(2 * column, 2 * row), fine.at(2 * column + 1, 2 * row),
                                            fine.at(2 * column, 2 * row + 1), fine.at(2 * column + 1, 2 * row + 1), 2);
    return coarse;
}

std::vector<float> cornersOf(const Patch& blocks) {
    const int squares = blocks.columns / 2, before = squares / 2 - 1;
    std::vector<float> corners;
    corners.reserve(std::size_t(squares + 1) * std::size_t(squares + 1));
    for (int row = before; row <= before + squares; ++row)
        for (int column = before; column <= before + squares; ++column)
            corners.push_back(meanOf(blocks.at(column, row), blocks.at(column + 1, row), blocks.at(column, row + 1),
                                     blocks.at(column + 1, row + 1), 1));
    return corners;
}

/// The color with the half transparent `line` over it.
std::uint32_t under(std::uint32_t line, std::uint32_t color) {
    const std::uint32_t alpha = line >> 24;
    const auto channel = [&](int shift) {
        return ((line >> shift & 0xff) * alpha + (color >> shift & 0xff) * (255 - alpha)) / 255 << shift;
    };
    return 0xff000000u | channel(16) | channel(8) | channel(0);
}

std::int8_t inParts(float light) {
    return static_cast<std::int8_t>(std::lround(light * ReliefTile::full_light));
}

std::vector<std::int8_t> cellLights(const Patch& cells, double cell_size_m) {
    constexpr int around = relief_side + 2; // Light depends on the next cell.
    std::vector<float> from_the_top(std::size_t(around) * around);
    for (int row = 0; row < around; ++row)
        for (int column = 0; column < around; ++column)
            from_the_top[static_cast<std::size_t>((around - 1 - row) * around + column)] =
                cells.at(margin - 1 + column, margin - 1 + row);
    const HeightGrid grid{from_the_top, around, around, cell_size_m};
    std::vector<std::int8_t> lights;
    lights.reserve(HeightTile::cell_count);
    for (int row = relief_side; row >= 1; --row)
        for (int column = 1; column <= relief_side; ++column)
            lights.push_back(std::isnan(grid.at(column, row)) ? std::int8_t(0) : inParts(lightOn(grid, column, row)));
    return lights;
}

/// The light of each block is the mean of the known blocks below it.
std::vector<std::int8_t> halvedLights(const ReliefTile& tile, int level) {
    const int squares = ReliefTile::squaresAt(level), fine = 2 * squares;
    std::vector<std::int8_t> coarse;
    coarse.reserve(static_cast<std::size_t>(squares * squares));
    for (int row = 0; row < fine; row += 2)
        for (int column = 0; column < fine; column += 2) {
            int known = 0, sum = 0;
            for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)})
                if (!std::isnan(tile.block_m(level - 1, column + x, row + y))) {
                    ++known;
                    sum += tile.levels[static_cast<std::size_t>(level) - 1]
                               .light[static_cast<std::size_t>((row + y) * fine + column + x)];
                }
            coarse.push_back(static_cast<std::int8_t>(known == 0 ? 0 : sum / known));
        }
    return coarse;
}

/// Returns the blocks over the tile, and one more on each side.
std::vector<float> blocksOf(const Patch& blocks) {
    const int squares = blocks.columns / 2, before = squares / 2 - 1;
    std::vector<float> heights_m;
    heights_m.reserve(std::size_t(squares + 2) * std::size_t(squares + 2));
    for (int row = before; row < before + squares + 2; ++row)
        for (int column = before; column < before + squares + 2; ++column)
            heights_m.push_back(blocks.at(column, row));
    return heights_m;
}

/// nullptr if no cell of the tile itself is known.
std::shared_ptr<const ReliefTile> tileFrom(Patch blocks, GridIndex index, double cell_size_m) {
    std::optional<CellBounds> known;
    int known_cells = 0;
    for (int row = 0; row < relief_side; ++row)
        for (int column = 0; column < relief_side; ++column)
            if (!std::isnan(blocks.at(margin + column, margin + row))) {
                CellBounds::include(known, {index.column * relief_side + column, index.row * relief_side + row});
                ++known_cells;
            }
    if (!known)
        return nullptr;
    auto tile = std::make_shared<ReliefTile>();
    tile->index = index;
    tile->known = *known;
    tile->known_cells = known_cells;
    tile->levels[0].light = cellLights(blocks, cell_size_m);
    for (int level = 0; level < ReliefTile::level_count; ++level) {
        ReliefTile::Level& made = tile->levels[static_cast<std::size_t>(level)];
        if (level > 0) {
            blocks = halved(blocks);
            made.light = halvedLights(*tile, level);
        }
        made.blocks_m = blocksOf(blocks);
        made.corners_m = cornersOf(blocks);
    }
    tile->range = HeightRange::of(tile->levels[0].corners_m).value_or(HeightRange{});
    return tile;
}

Patch patchAround(GridIndex index, const HeightTiles& tiles) {
    Patch patch;
    for (int d_row = -1; d_row <= 1; ++d_row)
        for (int d_column = -1; d_column <= 1; ++d_column) {
            const auto found = tiles.find({index.column + d_column, index.row + d_row});
            if (found == tiles.end())
                continue;
            const int first_column = d_column < 0 ? margin : 0, first_row = d_row < 0 ? margin : 0;
            const int end_column = d_column > 0 ? margin : relief_side, end_row = d_row > 0 ? margin : relief_side;
            for (int row = first_row; row < end_row; ++row)
                for (int column = first_column; column < end_column; ++column)
                    patch.at(margin + d_column * relief_side + column, margin + d_row * relief_side + row) =
                        found->second->preview_m[static_cast<std::size_t>(row * relief_side + column)];
        }
    return patch;
}

std::int32_t floorDivided(std::int64_t a, std::int64_t b) {
    return static_cast<std::int32_t>(a / b - (a % b < 0 ? 1 : 0));
}

/// A raster whose cells are the known means of two by two of this one's, aligned to even cells of the map.
Raster halved(const Raster& fine, std::int64_t first_column, std::int64_t top_row, const std::stop_token& stop) {
    const std::int64_t odd_left = first_column & 1, odd_top = ~top_row & 1;
    Raster coarse{(fine.columns + odd_left + 1) / 2, (fine.rows + odd_top + 1) / 2, 2.0 * fine.cell_size_m, {}, {}};
    coarse.upper_left_center_m = fine.upper_left_center_m + fine.cell_size_m * Vec2(0.5 - static_cast<double>(odd_left),
                                                                                    static_cast<double>(odd_top) - 0.5);
    const HeightGrid grid{fine.heights_m, fine.columns, fine.rows, fine.cell_size_m};
    coarse.heights_m.reserve(static_cast<std::size_t>(coarse.columns * coarse.rows));
    for (std::int64_t row = -odd_top; row < 2 * coarse.rows - odd_top && !stop.stop_requested(); row += 2)
        for (std::int64_t column = -odd_left; column < 2 * coarse.columns - odd_left; column += 2)
            coarse.heights_m.push_back(meanOf(grid.at(column, row), grid.at(column + 1, row), grid.at(column, row + 1),
                                              grid.at(column + 1, row + 1), 1));
    return coarse;
}

std::int64_t cellOf(double center_m, double cell_size_m) {
    return std::llround(center_m / cell_size_m - 0.5);
}

/// A surface with a level 0 cell for each of the raster's.
ReliefSurface reliefOfCells(const Raster& raster, const ReliefStyle& style, const std::stop_token& stop) {
    const std::int64_t first_column = cellOf(raster.upper_left_center_m.x(), raster.cell_size_m);
    const std::int64_t top_row = cellOf(raster.upper_left_center_m.y(), raster.cell_size_m);
    ReliefSurface surface{raster.cell_size_m, style, {}};
    const HeightGrid grid{raster.heights_m, raster.columns, raster.rows, raster.cell_size_m};
    const std::int64_t bottom_row = top_row - raster.rows + 1;
    for (std::int32_t row = floorDivided(bottom_row, relief_side); row <= floorDivided(top_row, relief_side); ++row)
        for (std::int32_t column = floorDivided(first_column, relief_side);
             column <= floorDivided(first_column + raster.columns - 1, relief_side); ++column) {
            if (stop.stop_requested())
                return surface;
            Patch patch;
            for (int y = 0; y < patch_side; ++y)
                for (int x = 0; x < patch_side; ++x)
                    patch.at(x, y) = grid.at(std::int64_t(column) * relief_side - margin + x - first_column,
                                             top_row - (std::int64_t(row) * relief_side - margin + y));
            if (auto tile = tileFrom(std::move(patch), {column, row}, raster.cell_size_m))
                surface.tiles[{column, row}] = std::move(tile);
        }
    return surface;
}

} // namespace

std::uint32_t squareColor(const ReliefTile& tile, int level, int column, int row, const ReliefStyle& style) {
    const ReliefTile::Level& of_level = tile.levels[static_cast<std::size_t>(level)];
    const int squares = ReliefTile::squaresAt(level);
    std::uint32_t color = shade(tile.block_m(level, column, row), style.range, style.color_map);
    if (color == 0)
        return 0;
    if (style.color_map == ColorMap::Color)
        color = lit(color, static_cast<float>(of_level.light[static_cast<std::size_t>(row * squares + column)]) /
                               ReliefTile::full_light);
    if (style.contour_step_m > 0.0) {
        // Contours are the same from below, so the order of the rows does not matter.
        const HeightGrid grid{of_level.blocks_m, squares + 2, squares + 2, 1.0};
        color = under(contourCell(grid, column + 1, row + 1, style.range, style.contour_step_m), color);
    }
    return color;
}

std::optional<float> ReliefSurface::height_m(const Vec2& point_in_map_m) const {
    const Vec2 place = point_in_map_m / cell_size_m;
    if (!place.allFinite() || place.cwiseAbs().maxCoeff() >= 1e9)
        return std::nullopt;
    const auto column = static_cast<std::int64_t>(std::floor(place.x()));
    const auto row = static_cast<std::int64_t>(std::floor(place.y()));
    const GridIndex index{floorDivided(column, relief_side), floorDivided(row, relief_side)};
    const auto found = tiles.find(index);
    if (found == tiles.end())
        return std::nullopt;
    const std::int64_t in_column = column - std::int64_t(index.column) * relief_side;
    const std::int64_t in_row = row - std::int64_t(index.row) * relief_side;
    if (std::isnan(found->second->block_m(0, static_cast<int>(in_column), static_cast<int>(in_row))))
        return std::nullopt;
    const auto right = static_cast<std::int64_t>(std::lround(place.x() - static_cast<double>(column)));
    const auto upper = static_cast<std::int64_t>(std::lround(place.y() - static_cast<double>(row)));
    return found->second->levels[0]
        .corners_m[static_cast<std::size_t>((in_row + upper) * (relief_side + 1) + in_column + right)];
}

std::optional<HeightRange> ReliefSurface::range() const {
    std::optional<HeightRange> range;
    for (const auto& [index, tile] : tiles) {
        HeightRange::include(range, tile->range.minimum_m);
        HeightRange::include(range, tile->range.maximum_m);
    }
    return range;
}

void renewRelief(ReliefSurface& surface, const HeightTiles& tiles, double cell_size_m,
                 std::span<const GridIndex> changed) {
    std::set<GridIndex> due;
    if (surface.cell_size_m != cell_size_m) {
        surface.cell_size_m = cell_size_m;
        surface.tiles.clear();
        for (const auto& [index, tile] : tiles)
            due.insert(index);
    }
    for (const GridIndex& index : changed)
        for (int d_row = -1; d_row <= 1; ++d_row)
            for (int d_column = -1; d_column <= 1; ++d_column)
                if (const GridIndex near{index.column + d_column, index.row + d_row}; tiles.contains(near))
                    due.insert(near);
    for (const GridIndex& index : due)
        if (auto tile = tileFrom(patchAround(index, tiles), index, cell_size_m))
            surface.tiles[index] = std::move(tile);
        else
            surface.tiles.erase(index);
}

ReliefSurface reliefOf(const Raster& raster, const ReliefStyle& style, std::int64_t most_cells,
                       const std::stop_token& stop) {
    if (raster.empty())
        return {.style = style};
    // Only one coarser raster is kept at a time, because each of a huge one takes much memory.
    Raster coarser;
    const Raster* cells = &raster;
    while (cells->columns * cells->rows > most_cells && cells->columns > 1 && cells->rows > 1) {
        coarser = halved(*cells, cellOf(cells->upper_left_center_m.x(), cells->cell_size_m),
                         cellOf(cells->upper_left_center_m.y(), cells->cell_size_m), stop);
        if (stop.stop_requested()) // Its last rows are missing.
            return {.style = style};
        cells = &coarser;
    }
    return reliefOfCells(*cells, style, stop);
}

} // namespace usar::mapping
