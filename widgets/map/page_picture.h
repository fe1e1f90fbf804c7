// The height map's pictures: finished images of squares of 4 x 4 tiles, with mip levels.
#pragma once

#include <array>
#include <memory>

#include <QImage>
#include <QRect>

#include "core/mapping/height_look.h"
#include "core/mapping/height_map.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// How heights are turned into pixels.
struct HeightStyle {
    mapping::HeightRange range;
    MapOrientation orientation = MapOrientation::XUp;
    mapping::ColorMap color_map = mapping::ColorMap::Color;
    double cell_size_m = 0.25;   ///< positive
    double contour_step_m = 0.0; ///< 0: no contours are drawn
};

/// The tiles of one page, indexed by column + row * tiles_per_side; null if nothing is known there.
struct PageTiles {
    static constexpr int tiles_per_side = 4;
    static constexpr int side = tiles_per_side * mapping::HeightTile::side; ///< in cells: 256

    static constexpr std::size_t count = std::size_t(tiles_per_side) * tiles_per_side;
    /// Pixels of the finest picture, which has one for each cell.
    static constexpr QRect whole{0, 0, side, side};

    mapping::GridIndex index; ///< in pages
    std::array<std::shared_ptr<const mapping::HeightTile>, count> tiles;
};

/// Pictures of a page: level 0 has one pixel per cell, each further level half the size. Already oriented for the
/// screen.
struct PagePicture {
    static constexpr std::size_t level_count = 4;
    using Levels = std::array<QImage, level_count>;
    Levels levels;
    Levels contours; ///< are transparent but for the lines; null images if no contours are drawn

    /// Returns the coarsest level that still has at least one pixel for every screen pixel.
    const QImage& levelFor(double screen_pixels_per_cell) const { return levels[indexFor(screen_pixels_per_cell)]; }
    const QImage& contoursFor(double screen_pixels_per_cell) const {
        return contours[indexFor(screen_pixels_per_cell)];
    }

private:
    static std::size_t indexFor(double screen_pixels_per_cell);
};

/// The distance of contour lines that divides a range into about ten: 1, 2 or 5 times a power of ten, in meters.
double contourStep_m(const mapping::HeightRange& range);

/// Renders a page; a pure function that takes about a millisecond, meant for a worker thread. Light and contours end at
/// the edge of the page.
PagePicture renderPage(const PageTiles& page, const HeightStyle& style);
/// The same if `before` is the page in the same style before the heights under these pixels of its finest picture
/// changed; only their part of it is rendered.
PagePicture renderAgain(const PageTiles& page, const HeightStyle& style, const PagePicture& before,
                        const QRect& changed_px);
/// The smallest rectangle of pixels of a page's finest picture in which two versions of its tile at `place` (an index
/// of PageTiles::tiles) look different; `before` may be nullptr, for a tile that is new. The result is empty if they
/// look alike.
QRect changedPixels(std::size_t place, const mapping::HeightTile* before, const mapping::HeightTile& after,
                    MapOrientation orientation);
/// The part of a page that is rendered again where these pixels changed: light and contours depend on the next cell.
/// Its edges are edges of pixels in all levels.
QRect partOf(const QRect& changed_px);
/// The ground under a part of a page's finest picture, in meters of the map frame.
Rectangle groundUnder(const QRect& part_px, mapping::GridIndex page, const HeightStyle& style);
/// Index of the page that contains the tile. Both count from the map's origin and may be negative.
mapping::GridIndex pageOfTile(mapping::GridIndex tile);
/// The ground that a page covers, in meters of the map frame.
Rectangle pageRectangle(mapping::GridIndex page, double cell_size_m);

} // namespace usar::widgets
