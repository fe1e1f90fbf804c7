#include "widgets/models/map/height_page.h"

#include <algorithm>

namespace usar::widgets {

namespace {

constexpr int tile_side = mapping::HeightTile::side;
using TilePixels = std::array<std::uint32_t, mapping::HeightTile::cell_count>;

std::uint32_t* scanLine(QImage& image, int y) {
    return reinterpret_cast<std::uint32_t*>(image.scanLine(y));
}
const std::uint32_t* scanLine(const QImage& image, int y) {
    return reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
}

/// Copies a tile into the picture. `pixels` have x to the right and y up; with x up and y left the picture is rotated
/// by a quarter turn counter-clockwise.
void place(QImage& image, const TilePixels& pixels, int tile_column, int tile_row, MapOrientation orientation) {
    const int last = PageTiles::tiles_per_side - 1;
    const bool x_up = orientation == MapOrientation::XUp;
    const int left = (x_up ? last - tile_row : tile_column) * tile_side;
    const int top = (x_up ? last - tile_column : last - tile_row) * tile_side;
    for (int y = 0; y < tile_side; ++y) {
        std::uint32_t* out = scanLine(image, top + y) + left;
        for (int x = 0; x < tile_side; ++x)
            out[x] = pixels[static_cast<std::size_t>(x_up ? x * tile_side + (tile_side - 1 - y) : y * tile_side + x)];
    }
}

/// Mean of four premultiplied pixels, two channels at a time.
std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t mask = 0x00ff00ff;
    const std::uint32_t low = ((a & mask) + (b & mask) + (c & mask) + (d & mask)) >> 2 & mask;
    const std::uint32_t high = ((a >> 8 & mask) + (b >> 8 & mask) + (c >> 8 & mask) + (d >> 8 & mask)) >> 2 & mask;
    return low | high << 8;
}

QImage halved(const QImage& image) {
    QImage half(image.width() / 2, image.height() / 2, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < half.height(); ++y) {
        const std::uint32_t* upper = scanLine(image, 2 * y);
        const std::uint32_t* lower = scanLine(image, 2 * y + 1);
        std::uint32_t* out = scanLine(half, y);
        for (int x = 0; x < half.width(); ++x)
            out[x] = mean(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
    }
    return half;
}

std::int32_t floorDivided(std::int32_t a, std::int32_t b) {
    return a / b - (a % b < 0 ? 1 : 0);
}

} // namespace

const QImage& PagePicture::levelFor(double screen_pixels_per_cell) const {
    std::size_t level = 0;
    while (level + 1 < level_count && screen_pixels_per_cell <= 0.5) {
        screen_pixels_per_cell *= 2.0;
        ++level;
    }
    return levels[level];
}

PagePicture renderPage(const PageTiles& page, const HeightStyle& style) {
    PagePicture picture;
    QImage& full = picture.levels[0];
    full = QImage(PageTiles::side, PageTiles::side, QImage::Format_ARGB32_Premultiplied);
    full.fill(Qt::transparent);
    auto pixels = std::make_unique<TilePixels>();
    for (std::size_t i = 0; i < page.tiles.size(); ++i) {
        if (!page.tiles[i])
            continue;
        mapping::shadeTile(*page.tiles[i], style.range, style.color_map, *pixels);
        // Shades are opaque or fully transparent; a transparent premultiplied pixel is zero in every channel.
        std::ranges::replace_if(
            *pixels, [](std::uint32_t pixel) { return pixel >> 24 == 0; }, 0u);
        place(full, *pixels, static_cast<int>(i) % PageTiles::tiles_per_side,
              static_cast<int>(i) / PageTiles::tiles_per_side, style.orientation);
    }
    for (std::size_t level = 1; level < PagePicture::level_count; ++level)
        picture.levels[level] = halved(picture.levels[level - 1]);
    return picture;
}

mapping::GridIndex pageOfTile(mapping::GridIndex tile) {
    return {floorDivided(tile.column, PageTiles::tiles_per_side), floorDivided(tile.row, PageTiles::tiles_per_side)};
}

Rectangle pageRectangle(mapping::GridIndex page, double cell_size_m) {
    const double side_m = PageTiles::side * cell_size_m;
    const Vec2 corner(page.column * side_m, page.row * side_m);
    return {corner, corner + Vec2(side_m, side_m)};
}

} // namespace usar::widgets
