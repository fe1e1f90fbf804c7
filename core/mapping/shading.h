// Heights to colors.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Both get lighter with height (thesis 4.2: darker shades are depths); Terrain runs from deep green over tan to snow.
enum class ColorMap { Gray, Terrain };

/// 0xAARRGGBB as QImage::Format_ARGB32 wants it; unknown heights are fully transparent. Heights outside the range take
/// the color of its end; a range without extent is the middle color.
std::uint32_t shade(float height_m, const HeightRange& range, ColorMap color_map);
/// The preview heights of a tile. `pixels` has HeightTile::cell_count entries, row 0 = highest y (pictures grow
/// downward, maps upward).
void shadeTile(const HeightTile& tile, const HeightRange& range, ColorMap color_map, std::span<std::uint32_t> pixels);

} // namespace usar::mapping
