#include "core/mapping/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace usar::mapping {

namespace {

constexpr std::uint32_t opaque(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return 0xff000000u | red << 16 | green << 8 | blue;
}

struct Stop {
    double red, green, blue;
};
// Samples of cividis at even distances. Luminance rises monotonically, so that the picture remains readable in gray.
constexpr std::array<Stop, 10> cividis_stops{{{0, 32, 77},
                                              {0, 51, 111},
                                              {57, 72, 107},
                                              {87, 92, 109},
                                              {112, 113, 115},
                                              {138, 135, 121},
                                              {166, 157, 117},
                                              {196, 181, 108},
                                              {228, 207, 91},
                                              {255, 234, 70}}};

constexpr std::uint32_t cividisColor(double part) {
    const double place = part * static_cast<double>(cividis_stops.size() - 1);
    const std::size_t from = std::min(static_cast<std::size_t>(place), cividis_stops.size() - 2);
    const Stop& low = cividis_stops[from];
    const Stop& high = cividis_stops[from + 1];
    const double mix = place - static_cast<double>(from);
    const auto channel = [mix](double below, double above) {
        return static_cast<std::uint32_t>(below + (above - below) * mix + 0.5);
    };
    return opaque(channel(low.red, high.red), channel(low.green, high.green), channel(low.blue, high.blue));
}

using Palette = std::array<std::uint32_t, 256>;

constexpr Palette makePalette(ColorMap color_map) {
    Palette palette{};
    for (std::uint32_t i = 0; i < palette.size(); ++i)
        palette[i] = color_map == ColorMap::Gray ? opaque(i, i, i) : cividisColor(i / 255.0);
    return palette;
}

constexpr Palette gray = makePalette(ColorMap::Gray);
constexpr Palette color = makePalette(ColorMap::Color);

/// Place of a height in the range: 0..1.
float partOf(float height_m, const HeightRange& range) {
    const float span_m = range.maximum_m - range.minimum_m;
    return span_m > 0.0f ? std::clamp((height_m - range.minimum_m) / span_m, 0.0f, 1.0f) : 0.5f;
}

/// Rise per meter from one neighbor over the cell to the other one; an unknown neighbor is left out.
float slope(float before_m, float here_m, float after_m, float cell_size_m) {
    const bool has_before = !std::isnan(before_m);
    const bool has_after = !std::isnan(after_m);
    if (!has_before && !has_after)
        return 0.0f;
    const float rise_m = (has_after ? after_m : here_m) - (has_before ? before_m : here_m);
    return rise_m / (cell_size_m * static_cast<float>(has_before + has_after));
}

} // namespace

std::uint32_t shade(float height_m, const HeightRange& range, ColorMap color_map) {
    if (std::isnan(height_m))
        return 0;
    return (color_map == ColorMap::Gray ? gray
                                        : color)[static_cast<std::size_t>(partOf(height_m, range) * 255.0f + 0.5f)];
}

float HeightGrid::at(std::int64_t column, std::int64_t row) const {
    const bool inside = column >= 0 && column < columns && row >= 0 && row < rows;
    return inside ? heights_m[static_cast<std::size_t>(row * columns + column)]
                  : std::numeric_limits<float>::quiet_NaN();
}

float lightOn(const HeightGrid& grid, std::int64_t column, std::int64_t row) {
    const float here_m = grid.at(column, row);
    const auto size_m = static_cast<float>(grid.cell_size_m);
    const float to_the_right = slope(grid.at(column - 1, row), here_m, grid.at(column + 1, row), size_m);
    const float downward = slope(grid.at(column, row - 1), here_m, grid.at(column, row + 1), size_m);
    constexpr float half_root = 0.70710678f;
    const float toward = (to_the_right + downward) * half_root;
    return toward / std::sqrt(1.0f + to_the_right * to_the_right + downward * downward);
}

std::uint32_t lit(std::uint32_t color_of_height, float light) {
    // The strengths leave the height readable on the steepest slope.
    constexpr float darkest = 0.55f;
    constexpr float lightest = 0.4f;
    const float target = light < 0.0f ? 0.0f : 255.0f;
    const float mix = light < 0.0f ? -light * darkest : light * lightest;
    const auto channel = [&](int shift) {
        const auto value = static_cast<float>(color_of_height >> shift & 0xff);
        return static_cast<std::uint32_t>(value + (target - value) * mix + 0.5f) << shift;
    };
    return 0xff000000u | channel(16) | channel(8) | channel(0);
}

std::uint32_t shadeCell(const HeightGrid& grid, std::int64_t column, std::int64_t row, const HeightRange& range,
                        ColorMap color_map) {
    const std::uint32_t flat = shade(grid.at(column, row), range, color_map);
    return flat == 0 || color_map == ColorMap::Gray ? flat : lit(flat, lightOn(grid, column, row));
}

std::uint32_t contourCell(const HeightGrid& grid, std::int64_t column, std::int64_t row, const HeightRange& range,
                          double step_m) {
    constexpr std::uint32_t light_line = 0x90ffffff;
    constexpr std::uint32_t dark_line = 0xa0000000;
    const float here_m = grid.at(column, row);
    if (std::isnan(here_m))
        return 0;
    // The line runs on its upper side, so that it is one cell wide. The comparison is false for unknown neighbors.
    const double level_m = std::floor(double(here_m) / step_m) * step_m;
    const bool passes = double(grid.at(column - 1, row)) < level_m || double(grid.at(column + 1, row)) < level_m ||
                        double(grid.at(column, row - 1)) < level_m || double(grid.at(column, row + 1)) < level_m;
    return !passes ? 0 : partOf(here_m, range) < 0.5f ? light_line : dark_line;
}

} // namespace usar::mapping
