#include "widgets/map/page_picture.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/mapping/shading.h"

namespace usar::widgets {

using mapping::GridIndex;
using mapping::HeightTile;

namespace {

constexpr int tile_side = HeightTile::side;
/// Heights of a whole page in the order of its picture.
using PageHeights = std::vector<float>;

std::uint32_t* scanLine(QImage& image, int y) {
    return reinterpret_cast<std::uint32_t*>(image.scanLine(y));
}
const std::uint32_t* scanLine(const QImage& image, int y) {
    return reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
}

/// Where a tile of a page is in its picture. With x up and y left the page is rotated by a quarter turn
/// counter-clockwise.
QRect rectOf(std::size_t tile, MapOrientation orientation) {
    const int last = PageTiles::tiles_per_side - 1;
    const int column = static_cast<int>(tile) % PageTiles::tiles_per_side;
    const int row = static_cast<int>(tile) / PageTiles::tiles_per_side;
    const bool x_up = orientation == MapOrientation::XUp;
    return {(x_up ? last - row : column) * tile_side, (x_up ? last - column : last - row) * tile_side, tile_side,
            tile_side};
}

/// Copies the preview of a tile into the page.
void place(PageHeights& heights_m, const mapping::HeightTile& tile, const QRect& at, MapOrientation orientation) {
    const bool x_up = orientation == MapOrientation::XUp;
    for (int y = 0; y < tile_side; ++y)
        for (int x = 0; x < tile_side; ++x) {
            const int upward = tile_side - 1 - y;
            const int cell = x_up ? (tile_side - 1 - x) * tile_side + upward : upward * tile_side + x;
            heights_m[static_cast<std::size_t>((at.top() + y) * PageTiles::side + at.left() + x)] =
                tile.preview_m[static_cast<std::size_t>(cell)];
        }
}

/// The heights under a part of the page's picture and around it, as far as light and contours reach.
PageHeights heightsOf(const PageTiles& page, MapOrientation orientation, const QRect& part) {
    PageHeights heights_m(std::size_t(PageTiles::side) * PageTiles::side, std::numeric_limits<float>::quiet_NaN());
    const QRect wanted = part.adjusted(-1, -1, 1, 1);
    for (std::size_t i = 0; i < page.tiles.size(); ++i)
        if (const QRect at = rectOf(i, orientation); page.tiles[i] && at.intersects(wanted))
            place(heights_m, *page.tiles[i], at, orientation);
    return heights_m;
}

/// Mean of four premultiplied pixels, two channels at a time.
std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t mask = 0x00ff00ff;
    const std::uint32_t low = ((a & mask) + (b & mask) + (c & mask) + (d & mask)) >> 2 & mask;
    const std::uint32_t high = ((a >> 8 & mask) + (b >> 8 & mask) + (c >> 8 & mask) + (d >> 8 & mask)) >> 2 & mask;
    return low | high << 8;
}

/// Puts the reduction of a part of the image, all of whose edges are even, into an image of half the size.
void halve(const QImage& image, const QRect& part, QImage& half) {
    for (int y = part.top() / 2; y <= part.bottom() / 2; ++y) {
        const std::uint32_t* upper = scanLine(image, 2 * y);
        const std::uint32_t* lower = scanLine(image, 2 * y + 1);
        std::uint32_t* out = scanLine(half, y);
        for (int x = part.left() / 2; x <= part.right() / 2; ++x)
            out[x] = mean(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
    }
}

/// Paints a part of the page's picture with what `colorOf(column, row)` gives, as premultiplied pixels, and of its
/// reductions.
template <class ColorOf>
void paint(PagePicture::Levels& levels, QRect part, const ColorOf& colorOf) {
    for (std::size_t level = 0; level < levels.size(); ++level)
        if (levels[level].isNull())
            levels[level] =
                QImage(PageTiles::side >> level, PageTiles::side >> level, QImage::Format_ARGB32_Premultiplied);
    for (int row = part.top(); row <= part.bottom(); ++row) {
        std::uint32_t* out = scanLine(levels[0], row);
        for (int column = part.left(); column <= part.right(); ++column)
            out[column] = qPremultiply(colorOf(column, row));
    }
    for (std::size_t level = 1; level < levels.size(); ++level) {
        halve(levels[level - 1], part, levels[level]);
        part = QRect(part.topLeft() / 2, part.size() / 2);
    }
}

void renderPart(const PageTiles& page, const HeightStyle& style, const QRect& part, PagePicture& picture) {
    const PageHeights heights_m = heightsOf(page, style.orientation, part);
    const mapping::HeightGrid grid{heights_m, PageTiles::side, PageTiles::side, style.cell_size_m};
    paint(picture.levels, part,
          [&](int column, int row) { return mapping::shadeCell(grid, column, row, style.range, style.color_map); });
    if (style.contour_step_m > 0.0)
        paint(picture.contours, part, [&](int column, int row) {
            return mapping::contourCell(grid, column, row, style.range, style.contour_step_m);
        });
}

std::int32_t floorDivided(std::int32_t a, std::int32_t b) {
    return a / b - (a % b < 0 ? 1 : 0);
}

} // namespace

std::size_t PagePicture::indexFor(double screen_pixels_per_cell) {
    std::size_t level = 0;
    while (level + 1 < level_count && screen_pixels_per_cell <= 0.5) {
        screen_pixels_per_cell *= 2.0;
        ++level;
    }
    return level;
}

double contourStep_m(const mapping::HeightRange& range) {
    return roundStep((double(range.maximum_m) - double(range.minimum_m)) / 5.0);
}

PagePicture renderPage(const PageTiles& page, const HeightStyle& style) {
    PagePicture picture;
    renderPart(page, style, PageTiles::whole, picture);
    return picture;
}

PagePicture renderAgain(const PageTiles& page, const HeightStyle& style, const PagePicture& before,
                        const QRect& changed_px) {
    PagePicture picture = before;
    renderPart(page, style, partOf(changed_px), picture);
    return picture;
}

QRect changedPixels(std::size_t place, const HeightTile* before, const HeightTile& after, MapOrientation orientation) {
    const auto bitsOf = [](float height_m) { return std::bit_cast<std::uint32_t>(height_m); }; // NaN equals NaN.
    std::optional<mapping::CellBounds> cells;
    for (std::size_t i = 0; i < HeightTile::cell_count; ++i)
        if (before ? bitsOf(before->preview_m[i]) != bitsOf(after.preview_m[i]) : !std::isnan(after.preview_m[i]))
            mapping::CellBounds::include(cells, {int(i) % tile_side, int(i) / tile_side});
    if (!cells)
        return {};
    const QPoint corner = rectOf(place, orientation).topLeft();
    constexpr int last = tile_side - 1;
    if (orientation == MapOrientation::XUp)
        return {corner + QPoint(last - cells->last.row, last - cells->last.column),
                corner + QPoint(last - cells->first.row, last - cells->first.column)};
    return {corner + QPoint(cells->first.column, last - cells->last.row),
            corner + QPoint(cells->last.column, last - cells->first.row)};
}

mapping::GridIndex pageOfTile(mapping::GridIndex tile) {
    return {floorDivided(tile.column, PageTiles::tiles_per_side), floorDivided(tile.row, PageTiles::tiles_per_side)};
}

Rectangle pageRectangle(mapping::GridIndex page, double cell_size_m) {
    const double side_m = PageTiles::side * cell_size_m;
    const Vec2 corner(page.column * side_m, page.row * side_m);
    return {corner, corner + Vec2(side_m, side_m)};
}

QRect partOf(const QRect& changed_px) {
    constexpr int coarsest = 1 << (PagePicture::level_count - 1);
    if (changed_px.isEmpty())
        return {};
    const auto edgeBefore = [](int px) { return (px - 1) & -coarsest; };
    const auto edgeAfter = [](int px) { return (px + 1) | (coarsest - 1); };
    return QRect(QPoint(edgeBefore(changed_px.left()), edgeBefore(changed_px.top())),
                 QPoint(edgeAfter(changed_px.right()), edgeAfter(changed_px.bottom()))) &
           PageTiles::whole;
}

Rectangle groundUnder(const QRect& part, GridIndex page, const HeightStyle& style) {
    const Rectangle all = pageRectangle(page, style.cell_size_m);
    const Vec2 upper_left = style.cell_size_m * Vec2(part.left(), part.top());
    const Vec2 lower_right = style.cell_size_m * Vec2(part.right() + 1, part.bottom() + 1);
    if (style.orientation == MapOrientation::XUp)
        return {all.max_m - Vec2(lower_right.y(), lower_right.x()), all.max_m - Vec2(upper_left.y(), upper_left.x())};
    return {Vec2(all.min_m.x() + upper_left.x(), all.max_m.y() - lower_right.y()),
            Vec2(all.min_m.x() + lower_right.x(), all.max_m.y() - upper_left.y())};
}

} // namespace usar::widgets
