#include "core/mapping/raster_export.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"

namespace usar::mapping {

namespace {

constexpr std::int64_t side = HeightTile::side;

std::int32_t middle(std::vector<std::int32_t> values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

/// Tiles that lie within half the longest side of the middle one.
std::vector<const HeightTile*> tilesWithinReach(const HeightMap& map) {
    const std::vector<GridIndex> indices = map.tileIndices();
    std::vector<std::int32_t> columns, rows;
    for (const GridIndex& index : indices) {
        columns.push_back(index.column);
        rows.push_back(index.row);
    }
    std::vector<const HeightTile*> tiles;
    const GridIndex center = indices.empty() ? GridIndex{} : GridIndex{middle(columns), middle(rows)};
    constexpr std::int64_t reach = maximum_raster_side / side / 2 - 1;
    for (const GridIndex& index : indices) {
        if (std::abs(std::int64_t(index.column) - center.column) <= reach &&
            std::abs(std::int64_t(index.row) - center.row) <= reach)
            tiles.push_back(map.tile(index));
    }
    return tiles;
}

GridIndex cellOf(const HeightTile& tile, std::size_t offset) {
    return {tile.index.column * HeightTile::side + static_cast<std::int32_t>(offset) % HeightTile::side,
            tile.index.row * HeightTile::side + static_cast<std::int32_t>(offset) / HeightTile::side};
}

std::optional<CellBounds> knownBounds(const std::vector<const HeightTile*>& tiles) {
    std::optional<CellBounds> bounds;
    for (const HeightTile* tile : tiles) {
        for (std::size_t i = 0; i < HeightTile::cell_count; ++i) {
            if (std::isnan(tile->height_m[i]))
                continue;
            const GridIndex cell = cellOf(*tile, i);
            if (!bounds)
                bounds = CellBounds{cell, cell};
            bounds->first = {std::min(bounds->first.column, cell.column), std::min(bounds->first.row, cell.row)};
            bounds->last = {std::max(bounds->last.column, cell.column), std::max(bounds->last.row, cell.row)};
        }
    }
    return bounds;
}

} // namespace

std::optional<HeightRange> Raster::range() const {
    std::optional<HeightRange> range;
    for (const float height_m : heights_m) {
        if (std::isnan(height_m))
            continue;
        if (!range)
            range = HeightRange{height_m, height_m};
        range->minimum_m = std::min(range->minimum_m, height_m);
        range->maximum_m = std::max(range->maximum_m, height_m);
    }
    return range;
}

std::size_t Raster::knownCellCount() const {
    return static_cast<std::size_t>(
        std::count_if(heights_m.begin(), heights_m.end(), [](float height_m) { return !std::isnan(height_m); }));
}

Raster rasterOf(const HeightMap& map) {
    const std::vector<const HeightTile*> tiles = tilesWithinReach(map);
    const std::optional<CellBounds> bounds = knownBounds(tiles);
    Raster raster;
    raster.cell_size_m = map.cellSize_m();
    if (!bounds)
        return raster;
    raster.columns = bounds->columns();
    raster.rows = bounds->rows();
    raster.upper_left_center_m = map.center_m({bounds->first.column, bounds->last.row});
    raster.heights_m.assign(static_cast<std::size_t>(raster.columns * raster.rows),
                            std::numeric_limits<float>::quiet_NaN());
    for (const HeightTile* tile : tiles) {
        for (std::size_t i = 0; i < HeightTile::cell_count; ++i) {
            if (std::isnan(tile->height_m[i]))
                continue;
            const GridIndex cell = cellOf(*tile, i);
            const std::int64_t row = std::int64_t(bounds->last.row) - cell.row;
            const std::int64_t column = std::int64_t(cell.column) - bounds->first.column;
            raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)] = tile->height_m[i];
        }
    }
    return raster;
}

std::vector<char> bilBytes(const Raster& raster) {
    std::vector<char> bytes;
    bytes.reserve(raster.heights_m.size() * sizeof(float));
    for (const float height_m : raster.heights_m) {
        const auto bits = std::bit_cast<std::uint32_t>(std::isnan(height_m) ? no_data_m : height_m);
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(static_cast<char>(bits >> shift & 0xffu));
    }
    return bytes;
}

std::string bilHeader(const Raster& raster) {
    std::string text;
    const auto word = [&text](const std::string& key, const std::string& value) {
        text += key + std::string(15 - key.size(), ' ') + value + '\n';
    };
    const auto number = [&word](const std::string& key, double value) {
        std::string digits;
        appendShortest(digits, value);
        word(key, digits);
    };
    word("BYTEORDER", "I");
    word("LAYOUT", "BIL");
    word("NROWS", std::to_string(raster.rows));
    word("NCOLS", std::to_string(raster.columns));
    word("NBANDS", "1");
    word("NBITS", "32");
    word("BANDROWBYTES", std::to_string(raster.columns * 4));
    word("TOTALROWBYTES", std::to_string(raster.columns * 4));
    word("PIXELTYPE", "FLOAT");
    number("ULXMAP", raster.upper_left_center_m.x());
    number("ULYMAP", raster.upper_left_center_m.y());
    number("XDIM", raster.cell_size_m);
    number("YDIM", raster.cell_size_m);
    number("NODATA", double(no_data_m));
    return text;
}

} // namespace usar::mapping
