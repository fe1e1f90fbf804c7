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

std::vector<std::uint32_t> cellColors(const Patch& cells, double cell_size_m, const ReliefStyle& style) {
    constexpr int around = relief_side + 2; // Light and contours depend on the next cell.
    std::vector<float> from_the_top(std::size_t(around) * around);
    for (int row = 0; row < around; ++row)
        for (int column = 0; column < around; ++column)
            from_the_top[static_cast<std::size_t>((around - 1 - row) * around + column)] =
                cells.at(margin - 1 + column, margin - 1 + row);
    const HeightGrid grid{from_the_top, around, around, cell_size_m};
    std::vector<std::uint32_t> colors;
    colors.reserve(HeightTile::cell_count);
    for (int row = relief_side; row >= 1; --row)
        for (int column = 1; column <= relief_side; ++column) {
            std::uint32_t color = shadeCell(grid, column, row, style.range, style.color_map);
            if (color != 0 && style.contour_step_m > 0.0)
                color = under(contourCell(grid, column, row, style.range, style.contour_step_m), color);
            colors.push_back(color);
        }
    return colors;
}

/// Colors of blocks from those of the blocks below them; 0 for unknown ones.
std::vector<std::uint32_t> halvedColors(const std::vector<std::uint32_t>& fine, int fine_side) {
    std::vector<std::uint32_t> coarse;
    coarse.reserve(fine.size() / 4);
    for (int row = 0; row < fine_side; row += 2)
        for (int column = 0; column < fine_side; column += 2) {
            const auto* const lower = &fine[static_cast<std::size_t>(row * fine_side + column)];
            std::uint32_t known = 0, red = 0, green = 0, blue = 0;
            for (const std::uint32_t color : {lower[0], lower[1], lower[fine_side], lower[fine_side + 1]}) {
                known += color >> 31;
                red += color >> 16 & 0xff;
                green += color >> 8 & 0xff;
                blue += color & 0xff;
            }
            coarse.push_back(known < 2 ? 0 : 0xff000000u | red / known << 16 | green / known << 8 | blue / known);
        }
    return coarse;
}

/// nullptr if no cell of the tile itself is known.
std::shared_ptr<const ReliefTile> tileFrom(Patch blocks, GridIndex index, double cell_size_m,
                                           const ReliefStyle& style) {
    auto tile = std::make_shared<ReliefTile>();
    tile->index = index;
    tile->levels[0].colors = cellColors(blocks, cell_size_m, style);
    std::optional<CellBounds> known;
    for (std::int32_t i = 0; i < relief_side * relief_side; ++i)
        if (tile->levels[0].colors[static_cast<std::size_t>(i)] != 0)
            CellBounds::include(
                known, {index.column * relief_side + i % relief_side, index.row * relief_side + i / relief_side});
    if (!known)
        return nullptr;
    tile->known = *known;
    for (int level = 0; level < ReliefTile::level_count; ++level) {
        ReliefTile::Level& made = tile->levels[static_cast<std::size_t>(level)];
        if (level > 0) {
            blocks = halved(blocks);
            made.colors = halvedColors(tile->levels[static_cast<std::size_t>(level) - 1].colors,
                                       ReliefTile::squaresAt(level - 1));
        }
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
Raster halved(const Raster& fine, std::int64_t first_column, std::int64_t top_row) {
    const std::int64_t odd_left = first_column & 1, odd_top = ~top_row & 1;
    Raster coarse{(fine.columns + odd_left + 1) / 2, (fine.rows + odd_top + 1) / 2, 2.0 * fine.cell_size_m, {}, {}};
    coarse.upper_left_center_m = fine.upper_left_center_m + fine.cell_size_m * Vec2(0.5 - static_cast<double>(odd_left),
                                                                                    static_cast<double>(odd_top) - 0.5);
    const HeightGrid grid{fine.heights_m, fine.columns, fine.rows, fine.cell_size_m};
    coarse.heights_m.reserve(static_cast<std::size_t>(coarse.columns * coarse.rows));
    for (std::int64_t row = -odd_top; row < 2 * coarse.rows - odd_top; row += 2)
        for (std::int64_t column = -odd_left; column < 2 * coarse.columns - odd_left; column += 2)
            coarse.heights_m.push_back(meanOf(grid.at(column, row), grid.at(column + 1, row), grid.at(column, row + 1),
                                              grid.at(column + 1, row + 1), 1));
    return coarse;
}

std::int64_t cellOf(double center_m, double cell_size_m) {
    return std::llround(center_m / cell_size_m - 0.5);
}

/// A surface with a level 0 cell for each of the raster's.
ReliefSurface reliefOfCells(const Raster& raster, const ReliefStyle& style) {
    const std::int64_t first_column = cellOf(raster.upper_left_center_m.x(), raster.cell_size_m);
    const std::int64_t top_row = cellOf(raster.upper_left_center_m.y(), raster.cell_size_m);
    ReliefSurface surface{raster.cell_size_m, style, {}};
    const HeightGrid grid{raster.heights_m, raster.columns, raster.rows, raster.cell_size_m};
    const std::int64_t bottom_row = top_row - raster.rows + 1;
    for (std::int32_t row = floorDivided(bottom_row, relief_side); row <= floorDivided(top_row, relief_side); ++row)
        for (std::int32_t column = floorDivided(first_column, relief_side);
             column <= floorDivided(first_column + raster.columns - 1, relief_side); ++column) {
            Patch patch;
            for (int y = 0; y < patch_side; ++y)
                for (int x = 0; x < patch_side; ++x)
                    patch.at(x, y) = grid.at(std::int64_t(column) * relief_side - margin + x - first_column,
                                             top_row - (std::int64_t(row) * relief_side - margin + y));
            if (auto tile = tileFrom(std::move(patch), {column, row}, raster.cell_size_m, style))
                surface.tiles[{column, row}] = std::move(tile);
        }
    return surface;
}

std::int64_t tilesApart(GridIndex a, GridIndex b) {
    return std::max(std::abs(std::int64_t(a.column) - b.column), std::abs(std::int64_t(a.row) - b.row));
}

/// The tiles that may be in one raster with the one nearest to the median; at least that one, unless there are none.
std::vector<const ReliefTile*> tilesTogether(const ReliefSurface& surface) {
    const auto middle_of = [&surface](std::int32_t GridIndex::*part) {
        std::vector<std::int32_t> values;
        for (const auto& [index, tile] : surface.tiles)
            values.push_back(index.*part);
        const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), half, values.end());
        return *half;
    };
    std::vector<const ReliefTile*> together;
    if (surface.tiles.empty())
        return together;
    const GridIndex median{middle_of(&GridIndex::column), middle_of(&GridIndex::row)};
    const GridIndex center = std::ranges::min_element(surface.tiles, {}, [median](const auto& entry) {
                                 return tilesApart(entry.first, median);
                             })->first;
    for (const auto& [index, tile] : surface.tiles)
        if (tilesApart(index, center) <= maximum_raster_side / relief_side)
            together.push_back(tile.get());
    return together;
}

} // namespace

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
    const ReliefTile::Level& finest = found->second->levels[0];
    if (finest.colors[static_cast<std::size_t>(in_row * relief_side + in_column)] == 0)
        return std::nullopt;
    const auto right = static_cast<std::int64_t>(std::lround(place.x() - static_cast<double>(column)));
    const auto upper = static_cast<std::int64_t>(std::lround(place.y() - static_cast<double>(row)));
    return finest.corners_m[static_cast<std::size_t>((in_row + upper) * (relief_side + 1) + in_column + right)];
}

std::optional<HeightRange> ReliefSurface::range() const {
    std::optional<HeightRange> range;
    for (const auto& [index, tile] : tiles) {
        HeightRange::include(range, tile->range.minimum_m);
        HeightRange::include(range, tile->range.maximum_m);
    }
    return range;
}

std::vector<Vec3> ReliefSurface::someCorners() const {
    constexpr int step = 4;
    std::vector<Vec3> corners;
    const std::vector<const ReliefTile*> together = tilesTogether(*this);
    for (const ReliefTile* const tile : together)
        for (int row = 0; row <= relief_side; row += step)
            for (int column = 0; column <= relief_side; column += step) {
                const float height_m =
                    tile->levels[0].corners_m[static_cast<std::size_t>(row * (relief_side + 1) + column)];
                if (!std::isnan(height_m))
                    corners.emplace_back(cell_size_m * (tile->index.column * double(relief_side) + column),
                                         cell_size_m * (tile->index.row * double(relief_side) + row), double(height_m));
            }
    if (corners.empty()) // Single cells may lie between all of these.
        for (const ReliefTile* const tile : together) {
            const CellBounds& known = tile->known;
            corners.emplace_back(cell_size_m * known.first.column, cell_size_m * known.first.row,
                                 double(tile->range.minimum_m));
            corners.emplace_back(cell_size_m * (known.last.column + 1.0), cell_size_m * (known.last.row + 1.0),
                                 double(tile->range.maximum_m));
        }
    return corners;
}

Rectangle ReliefSurface::bounds_in_map() const {
    if (tiles.empty())
        return {};
    std::optional<CellBounds> known;
    for (const ReliefTile* const tile : tilesTogether(*this)) {
        CellBounds::include(known, tile->known.first);
        CellBounds::include(known, tile->known.last);
    }
    return {cell_size_m * Vec2(known->first.column, known->first.row),
            cell_size_m * Vec2(known->last.column + 1.0, known->last.row + 1.0)};
}

void renewRelief(ReliefSurface& surface, const HeightTiles& tiles, double cell_size_m, const ReliefStyle& style,
                 std::span<const GridIndex> changed) {
    std::set<GridIndex> due;
    if (surface.style != style || surface.cell_size_m != cell_size_m) {
        surface.style = style;
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
        if (auto tile = tileFrom(patchAround(index, tiles), index, cell_size_m, style))
            surface.tiles[index] = std::move(tile);
        else
            surface.tiles.erase(index);
}

ReliefSurface reliefOf(const Raster& raster, const ReliefStyle& style, std::int64_t most_cells) {
    if (raster.empty())
        return {.style = style};
    // Only one coarser raster is kept at a time, because each of a huge one takes much memory.
    Raster coarser;
    const Raster* cells = &raster;
    while (cells->columns * cells->rows > most_cells && cells->columns > 1 && cells->rows > 1) {
        coarser = halved(*cells, cellOf(cells->upper_left_center_m.x(), cells->cell_size_m),
                         cellOf(cells->upper_left_center_m.y(), cells->cell_size_m));
        cells = &coarser;
    }
    return reliefOfCells(*cells, style);
}

} // namespace usar::mapping
