#include "core/mapping/raster_export.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

#include "core/base/numbers.h"

namespace usar::mapping {

namespace {

constexpr std::int64_t side = HeightTile::side;
/// Cells may have an odd size, so that their centers need a millimeter and a bit.
constexpr int text_decimals = 4;

std::int32_t middle(std::vector<std::int32_t> values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

/// True if one raster may hold `tile_count` tiles within these bounds, which count in tiles.
bool fitInOne(const CellBounds& tiles, std::size_t tile_count) {
    const std::int64_t columns = tiles.columns() * side;
    const std::int64_t rows = tiles.rows() * side;
    const std::int64_t room = std::max(roomy_raster_cells, 4 * std::int64_t(tile_count) * side * side);
    return columns <= maximum_raster_side && rows <= maximum_raster_side && columns * rows <= room;
}

/// Removes from `indices`, which must not be empty, as many tiles as fit into one raster, nearest to the median tile
/// first, and returns them.
std::vector<const HeightTile*> takeTilesForOne(const HeightMap& map, std::vector<GridIndex>& indices) {
    std::vector<std::int32_t> columns, rows;
    for (const GridIndex& index : indices) {
        columns.push_back(index.column);
        rows.push_back(index.row);
    }
    const GridIndex center{middle(columns), middle(rows)};
    std::ranges::stable_sort(indices, {}, [center](const GridIndex& index) {
        return std::max(std::abs(std::int64_t(index.column) - center.column),
                        std::abs(std::int64_t(index.row) - center.row));
    });
    std::optional<CellBounds> bounds;
    std::size_t fitting = 1;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        CellBounds::include(bounds, indices[i]);
        if (fitInOne(*bounds, i + 1))
            fitting = i + 1;
    }
    std::vector<const HeightTile*> tiles(fitting);
    const auto rest = indices.begin() + static_cast<std::ptrdiff_t>(fitting);
    std::transform(indices.begin(), rest, tiles.begin(), [&map](GridIndex index) { return map.tile(index); });
    indices.erase(indices.begin(), rest);
    return tiles;
}

GridIndex cellOf(const HeightTile& tile, std::size_t offset) {
    return {tile.index.column * HeightTile::side + static_cast<std::int32_t>(offset) % HeightTile::side,
            tile.index.row * HeightTile::side + static_cast<std::int32_t>(offset) / HeightTile::side};
}

std::optional<CellBounds> knownBounds(const std::vector<const HeightTile*>& tiles) {
    std::optional<CellBounds> bounds;
    for (const HeightTile* tile : tiles)
        for (std::size_t i = 0; i < HeightTile::cell_count; ++i)
            if (!std::isnan(tile->height_m[i]))
                CellBounds::include(bounds, cellOf(*tile, i));
    return bounds;
}

/// Makes a raster of the tiles, cropped to the known cells.
Raster rasterOfTiles(const HeightMap& map, const std::vector<const HeightTile*>& tiles) {
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
    for (const HeightTile* tile : tiles)
        for (std::size_t i = 0; i < HeightTile::cell_count; ++i) {
            if (std::isnan(tile->height_m[i]))
                continue;
            const GridIndex cell = cellOf(*tile, i);
            const std::int64_t row = std::int64_t(bounds->last.row) - cell.row;
            const std::int64_t column = std::int64_t(cell.column) - bounds->first.column;
            raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)] = tile->height_m[i];
        }
    return raster;
}

} // namespace

std::optional<HeightRange> Raster::range() const {
    return HeightRange::of(heights_m);
}

std::size_t Raster::knownCellCount() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(heights_m, [](float height_m) { return !std::isnan(height_m); }));
}

std::vector<Raster> rastersOf(const HeightMap& map, std::size_t most) {
    std::vector<GridIndex> indices = map.tileIndices();
    std::vector<Raster> rasters;
    while (!indices.empty() && rasters.size() < most) {
        Raster raster = rasterOfTiles(map, takeTilesForOne(map, indices));
        if (!raster.empty())
            rasters.push_back(std::move(raster));
    }
    return rasters;
}

Raster rasterOf(const HeightMap& map) {
    Raster empty;
    empty.cell_size_m = map.cellSize_m();
    std::vector<Raster> rasters = rastersOf(map, 1);
    return rasters.empty() ? empty : std::move(rasters.front());
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

std::string asciiGrid(const Raster& raster) {
    std::string text;
    writeAsciiGrid(raster, [&text](const char* bytes, std::size_t count) {
        text.append(bytes, count);
        return true;
    });
    return text;
}

bool writeAsciiGrid(const Raster& raster, const ByteSink& sink) {
    const Vec2 lower_left_m = raster.upper_left_center_m - Vec2(0.5, double(raster.rows) - 0.5) * raster.cell_size_m;
    std::string text = "ncols " + std::to_string(raster.columns) + "\nnrows " + std::to_string(raster.rows);
    for (const auto& [key, value] : {std::pair("xllcorner", lower_left_m.x()), std::pair("yllcorner", lower_left_m.y()),
                                     std::pair("cellsize", raster.cell_size_m)}) {
        text += std::string("\n") + key + ' ';
        appendShortest(text, value);
    }
    text += "\nNODATA_value " + fixed(double(no_data_m), 0) + '\n';
    if (!sink(text.data(), text.size()))
        return false;
    const auto columns = static_cast<std::size_t>(raster.columns);
    for (std::size_t first = 0; first < raster.heights_m.size(); first += columns) {
        text.clear();
        for (const float height_m : std::span(raster.heights_m).subspan(first, columns)) {
            text += std::isnan(height_m) ? fixed(double(no_data_m), 0) : fixed(double(height_m), text_decimals);
            text += ' ';
        }
        text.back() = '\n';
        if (!sink(text.data(), text.size()))
            return false;
    }
    return true;
}

std::string xyzPoints(const Raster& raster) {
    std::string text = "x y z\n";
    for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
        if (std::isnan(raster.heights_m[i]))
            continue;
        const auto column = double(i % static_cast<std::size_t>(raster.columns));
        const auto row = double(i / static_cast<std::size_t>(raster.columns));
        for (const double center_m : {raster.upper_left_center_m.x() + column * raster.cell_size_m,
                                      raster.upper_left_center_m.y() - row * raster.cell_size_m})
            text += fixed(center_m, text_decimals) + ' ';
        text += fixed(double(raster.heights_m[i]), text_decimals) + '\n';
    }
    return text;
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

std::optional<Raster> readBilHeader(std::string_view text) {
    std::map<std::string, std::string> words;
    std::istringstream lines{std::string(text)};
    for (std::string key, word; lines >> key >> word;)
        words[key] = word;
    if (words["BYTEORDER"] != "I" || words["NBITS"] != "32" || words["PIXELTYPE"] != "FLOAT")
        return std::nullopt;
    const auto rows = readInteger(words["NROWS"]), columns = readInteger(words["NCOLS"]);
    const auto x_m = readNumber(words["ULXMAP"]), y_m = readNumber(words["ULYMAP"]), cell_m = readNumber(words["XDIM"]);
    if (!rows || !columns || !x_m || !y_m || !cell_m)
        return std::nullopt;
    return Raster{*columns, *rows, *cell_m, {*x_m, *y_m}, {}};
}

bool takeBilBytes(Raster& raster, std::span<const char> bytes) {
    const bool plausible = raster.columns > 0 && raster.rows > 0 && raster.columns <= maximum_raster_side &&
                           raster.rows <= maximum_raster_side && raster.cell_size_m > 0.0;
    if (!plausible || bytes.size() != std::size_t(raster.columns * raster.rows) * sizeof(float))
        return false;
    raster.heights_m.resize(bytes.size() / sizeof(float));
    for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
        std::uint32_t bits = 0;
        for (std::size_t byte = 0; byte < sizeof(float); ++byte)
            bits |= std::uint32_t(static_cast<unsigned char>(bytes[i * sizeof(float) + byte])) << (8 * byte);
        const auto height_m = std::bit_cast<float>(bits);
        raster.heights_m[i] = height_m == no_data_m ? std::numeric_limits<float>::quiet_NaN() : height_m;
    }
    return true;
}

} // namespace usar::mapping
