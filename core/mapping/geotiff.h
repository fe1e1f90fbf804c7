// Writes a raster of heights as a GeoTIFF, without a library.
#pragma once

#include "core/mapping/byte_stream.h"
#include "core/mapping/raster_export.h"

namespace usar::mapping {

/// Side of the tiles in cells; those at the right and lower edge are filled up with `no_data_m`.
inline constexpr std::int64_t geotiff_tile = 256;

/// One band of float32, little-endian, uncompressed, in tiles; unknown cells are `no_data_m`, as the tag GDAL_NODATA
/// says. The coordinate system is a local one in meters named "map frame", x to the right and y up, and has no place on
/// the earth. The file of the largest possible raster takes 1.1 GB, so it needs no BigTIFF. Sends the file in pieces of
/// at most a tile; false as soon as `sink` is. `raster` must not be empty.
bool writeGeoTiff(const Raster& raster, const ByteSink& sink);

} // namespace usar::mapping
