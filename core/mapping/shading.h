// Converts heights to colors: by height, by light on the slopes, and by contour lines.
#pragma once

#include <cstdint>
#include <span>

#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Both get lighter with height. Color is cividis, a perceptual scale that color-blind people read as all others do; it
/// is lit like a relief. Gray is the picture of the thesis (4.2: darker shades are lower), without light.
enum class ColorMap { Color, Gray };

/// The color of a height as 0xAARRGGBB, the format of QImage::Format_ARGB32. Unknown heights (NaN) are zero, which is
/// fully transparent. Heights outside the range get the color of its nearest end; a range without extent gives the
/// middle color.
std::uint32_t shade(float height_m, const HeightRange& range, ColorMap color_map);

/// Heights in the order of a picture's pixels: row-major, row 0 at the top. NaN: unknown.
struct HeightGrid {
    std::span<const float> heights_m; ///< columns * rows of them
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    double cell_size_m = 0.25; ///< positive

    /// NaN outside the grid.
    float at(std::int64_t column, std::int64_t row) const;
};

/// The light on a cell of the grid, relative to level ground: from -1, turned away from the upper left, to 1; unknown
/// neighbors have no slope.
float lightOn(const HeightGrid& grid, std::int64_t column, std::int64_t row);
/// An opaque color mixed with black or white by the light on it.
std::uint32_t lit(std::uint32_t color, float light);

/// The color of a cell of the grid as shade() gives it. With ColorMap::Color, slopes that face the upper left of the
/// picture are lighter and those that face away are darker.
std::uint32_t shadeCell(const HeightGrid& grid, std::int64_t column, std::int64_t row, const HeightRange& range,
                        ColorMap color_map);

/// The color of the contour line through a cell, half transparent (0xAARRGGBB, not premultiplied); 0 if none passes
/// there. Lines lie at the multiples of `step_m`; they are light on low ground and dark on high ground.
std::uint32_t contourCell(const HeightGrid& grid, std::int64_t column, std::int64_t row, const HeightRange& range,
                          double step_m);

} // namespace usar::mapping
