// The map as a dense raster, and in the raw file formats that need no image library.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Row 0 is the highest y, as pictures and GIS want it; unknown cells are NaN. Heights are the array's, z up.
struct Raster {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    double cell_size_m = 0.0;
    Vec2 upper_left_center_m = Vec2::Zero(); ///< center of the first cell
    std::vector<float> heights_m;
    bool empty() const { return heights_m.empty(); }
    /// Of the known cells; nothing where none is known.
    std::optional<HeightRange> range() const;
    std::size_t knownCellCount() const;
};

/// A stray scan (a garbled position) can put a tile a thousand kilometres away, and a raster of all would fill memory
/// and disk with nothing. So no raster has a longer side than this, nor more cells than `roomy_raster_cells` unless a
/// quarter of them lies in tiles that are there.
inline constexpr std::int64_t maximum_raster_side = 16384;
inline constexpr std::int64_t roomy_raster_cells = std::int64_t(1) << 26;

/// All known cells: first the raster around the middle tile, as large as may be, then in the same way what lies too far
/// from it, and so on. No more than `most`, though garbled positions be many. Each is cropped to its known cells; empty
/// for an empty map.
std::vector<Raster> rastersOf(const HeightMap& map, std::size_t most = 64);

/// The first of them; an empty one for an empty map.
Raster rasterOf(const HeightMap& map);

/// NoData value of the raw file, as its header says.
inline constexpr float no_data_m = -9999.0f;
/// ESRI .bil (float32, little-endian, band interleaved by line) bytes and the text of its .hdr; GDAL opens the pair.
std::vector<char> bilBytes(const Raster& raster);
std::string bilHeader(const Raster& raster);

} // namespace usar::mapping
