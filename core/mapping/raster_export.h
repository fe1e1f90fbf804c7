// Converts the map to dense rasters, and these to the raw file formats that need no image library.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/byte_stream.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// How the name of a mission's picture ends; what is before it is the stem of all its files.
inline constexpr char picture_ending[] = "_picture.png";

/// A dense raster of heights from the map's array (z up), row-major. Row 0 has the highest y, as in pictures and GIS;
/// unknown cells are NaN.
struct Raster {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    double cell_size_m = 0.0;
    Vec2 upper_left_center_m = Vec2::Zero(); ///< center of the first cell, in the map frame
    std::vector<float> heights_m;
    bool empty() const { return heights_m.empty(); }
    /// The range of the known cells; nullopt if there are none.
    std::optional<HeightRange> range() const;
    std::size_t knownCellCount() const;
};

/// A stray scan with a garbled position can create a tile a thousand kilometers away, and a raster of everything would
/// fill memory and disk with unknown cells. Therefore no raster has a side longer than this many cells, nor more cells
/// than `roomy_raster_cells` unless at least a quarter of them lie in existing tiles.
inline constexpr std::int64_t maximum_raster_side = 16384;
inline constexpr std::int64_t roomy_raster_cells = std::int64_t(1) << 26;

/// Rasters of all known cells: first the largest permitted raster around the median tile, then in the same way one for
/// the tiles too far away from it, and so on, up to `most` rasters, in case there are many garbled positions. Each is
/// cropped to its known cells. Empty for an empty map.
std::vector<Raster> rastersOf(const HeightMap& map, std::size_t most = 64);

/// The first of these rasters; an empty raster for an empty map.
Raster rasterOf(const HeightMap& map);

/// The value for unknown cells in the raw file, as stated in its header.
inline constexpr float no_data_m = -9999.0f;
/// The bytes of an ESRI .bil file (float32, little-endian, band interleaved by line), and the text of its .hdr file;
/// GDAL opens the pair.
std::vector<char> bilBytes(const Raster& raster);
std::string bilHeader(const Raster& raster);
/// Reads a header that `bilHeader` has written: a raster whose heights are still to be filled in. nullopt if it is
/// another or a damaged one.
std::optional<Raster> readBilHeader(std::string_view text);
/// Fills in the heights of a raster of which the rest is known. False if it cannot be a raster, or if the bytes are not
/// those of its cells.
bool takeBilBytes(Raster& raster, std::span<const char> bytes);

/// Text formats state four decimals of a meter and take several times the room of the raw file, so a raster with more
/// cells than this is not worth writing as text (about 30 MB).
inline constexpr std::int64_t most_text_cells = std::int64_t(1) << 22;
/// The text of an ESRI ASCII grid (.asc); unknown cells are `no_data_m`. GIS programs and GDAL open it.
std::string asciiGrid(const Raster& raster);
/// Sends the same text row by row; false as soon as `sink` is.
bool writeAsciiGrid(const Raster& raster, const ByteSink& sink);
/// The known cells as lines "x y z" in meters, below a line that names them: .xyz, for point clouds and spreadsheets.
/// Row by row from the highest y.
std::string xyzPoints(const Raster& raster);

} // namespace usar::mapping
