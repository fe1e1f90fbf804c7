// Renders a square of 4 x 4 height tiles as a picture with mip levels, which the map then draws.
#pragma once

#include <array>
#include <memory>

#include <QImage>

#include "core/mapping/height_map.h"
#include "core/mapping/shading.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// How heights are turned into pixels.
struct HeightStyle {
    mapping::HeightRange range;
    mapping::ColorMap color_map = mapping::ColorMap::Gray;
    MapOrientation orientation = MapOrientation::XUp;
    bool operator==(const HeightStyle&) const = default;
};

/// The tiles of one page, indexed by column + row * tiles_per_side; null if nothing is known there.
struct PageTiles {
    static constexpr int tiles_per_side = 4;
    static constexpr int side = tiles_per_side * mapping::HeightTile::side; ///< in cells: 256

    mapping::GridIndex index; ///< in pages
    std::array<std::shared_ptr<const mapping::HeightTile>, std::size_t(tiles_per_side) * tiles_per_side> tiles;
};

/// Pictures of a page: level 0 has one pixel per cell, each further level half the size. Already oriented for the
/// screen.
struct PagePicture {
    static constexpr std::size_t level_count = 4;
    std::array<QImage, level_count> levels;

    /// Returns the coarsest level that still has at least one pixel for every screen pixel.
    const QImage& levelFor(double screen_pixels_per_cell) const;
};

/// Renders a page; a pure function that takes 0.1 to 0.3 ms, meant for a worker thread.
PagePicture renderPage(const PageTiles& page, const HeightStyle& style);

/// Index of the page that contains the tile. Both count from the map's origin and may be negative.
mapping::GridIndex pageOfTile(mapping::GridIndex tile);
/// The ground that a page covers, in meters of the map frame.
Rectangle pageRectangle(mapping::GridIndex page, double cell_size_m);

} // namespace usar::widgets
