// A square of 4 x 4 height tiles as a picture with mip levels: what the map blits.
#pragma once

#include <array>
#include <memory>

#include <QImage>

#include "core/mapping/height_map.h"
#include "core/mapping/shading.h"
#include "widgets/models/map_transform.h"

namespace usar::widgets {

/// How heights become pixels.
struct HeightStyle {
    mapping::HeightRange range;
    mapping::ColorMap color_map = mapping::ColorMap::Gray;
    MapOrientation orientation = MapOrientation::XUp;
    bool operator==(const HeightStyle&) const = default;
};

/// The tiles of one page, by column + row * tiles_per_side; null where nothing is known.
struct PageTiles {
    static constexpr int tiles_per_side = 4;
    static constexpr int side = tiles_per_side * mapping::HeightTile::side; ///< in cells: 256

    mapping::GridIndex index; ///< in pages
    std::array<std::shared_ptr<const mapping::HeightTile>, std::size_t(tiles_per_side) * tiles_per_side> tiles;
};

/// Level 0 has a pixel a cell; each next one half of that. Oriented for the screen.
struct PagePicture {
    static constexpr std::size_t level_count = 4;
    std::array<QImage, level_count> levels;

    /// The coarsest level that still has a pixel for every screen pixel.
    const QImage& levelFor(double screen_pixels_per_cell) const;
};

/// Pure and slow (0.1 to 0.3 ms): meant for a worker thread.
PagePicture renderPage(const PageTiles& page, const HeightStyle& style);

/// Both count from the map's origin, into the negative too.
mapping::GridIndex pageOfTile(mapping::GridIndex tile);
/// The ground that a page covers.
Rectangle pageRectangle(mapping::GridIndex page, double cell_size_m);

} // namespace usar::widgets
