// Converts heights to colors.
#pragma once

#include <cstdint>
#include <span>

#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Both get lighter with height (thesis 4.2: darker shades are lower). Terrain goes from dark green through tan to
/// white.
enum class ColorMap { Gray, Terrain };

/// The color of a height as 0xAARRGGBB, the format of QImage::Format_ARGB32. Unknown heights (NaN) are fully
/// transparent. Heights outside the range get the color of its nearest end; a range without extent gives the middle
/// color.
std::uint32_t shade(float height_m, const HeightRange& range, ColorMap color_map);
/// Colors the preview heights of a tile. `pixels` has HeightTile::cell_count entries; row 0 has the highest y, because
/// pictures grow downward and maps upward.
void shadeTile(const HeightTile& tile, const HeightRange& range, ColorMap color_map, std::span<std::uint32_t> pixels);

} // namespace usar::mapping
