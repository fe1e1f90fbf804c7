#include "core/mapping/shading.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace usar::mapping {

namespace {

constexpr std::uint32_t opaque(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return 0xff000000u | red << 16 | green << 8 | blue;
}

struct Stop {
    double at;
    double red, green, blue;
};
// Luminance rises monotonically, so that the picture remains readable in gray and for color-blind people.
constexpr std::array<Stop, 6> terrain_stops{{{0.00, 14, 40, 58},
                                             {0.20, 22, 84, 74},
                                             {0.42, 74, 128, 64},
                                             {0.64, 166, 164, 84},
                                             {0.84, 212, 190, 150},
                                             {1.00, 250, 248, 244}}};

constexpr std::uint32_t terrainColor(double part) {
    std::size_t next = 1;
    while (next + 1 < terrain_stops.size() && terrain_stops[next].at < part)
        ++next;
    const Stop& low = terrain_stops[next - 1];
    const Stop& high = terrain_stops[next];
    const double mix = (part - low.at) / (high.at - low.at);
    const auto channel = [mix](double from, double to) {
        return static_cast<std::uint32_t>(from + (to - from) * mix + 0.5);
    };
    return opaque(channel(low.red, high.red), channel(low.green, high.green), channel(low.blue, high.blue));
}

using Palette = std::array<std::uint32_t, 256>;

constexpr Palette makePalette(ColorMap color_map) {
    Palette palette{};
    for (std::uint32_t i = 0; i < palette.size(); ++i)
        palette[i] = color_map == ColorMap::Gray ? opaque(i, i, i) : terrainColor(i / 255.0);
    return palette;
}

constexpr Palette gray = makePalette(ColorMap::Gray);
constexpr Palette terrain = makePalette(ColorMap::Terrain);

} // namespace

std::uint32_t shade(float height_m, const HeightRange& range, ColorMap color_map) {
    if (std::isnan(height_m))
        return 0;
    const float span_m = range.maximum_m - range.minimum_m;
    const float part = span_m > 0.0f ? std::clamp((height_m - range.minimum_m) / span_m, 0.0f, 1.0f) : 0.5f;
    return (color_map == ColorMap::Gray ? gray : terrain)[static_cast<std::size_t>(part * 255.0f + 0.5f)];
}

void shadeTile(const HeightTile& tile, const HeightRange& range, ColorMap color_map, std::span<std::uint32_t> pixels) {
    assert(pixels.size() == HeightTile::cell_count);
    constexpr auto side = static_cast<std::size_t>(HeightTile::side);
    for (std::size_t row = 0; row < side; ++row) {
        const std::size_t target = (side - 1 - row) * side;
        for (std::size_t column = 0; column < side; ++column)
            pixels[target + column] = shade(tile.preview_m[row * side + column], range, color_map);
    }
}

} // namespace usar::mapping
