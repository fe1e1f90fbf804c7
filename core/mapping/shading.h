// Heights to colors.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/mapping/height_map.h"

namespace usar::mapping {

enum class ColorMap { Gray, Terrain };

/// 0xAARRGGBB as QImage::Format_ARGB32 wants it; unknown heights are fully transparent.
std::uint32_t shade(float height_m, const HeightRange& range, ColorMap color_map);
/// `pixels` has HeightTile::cell_count entries, row 0 = highest y (pictures grow downward, maps upward).
void shadeTile(const HeightTile& tile, const HeightRange& range, ColorMap color_map, std::span<std::uint32_t> pixels);

} // namespace usar::mapping
