// The scan preview of the thesis (4.2) as the map's height layer: tiles go in; finished pictures of squares of 4 x 4
// tiles, with mip levels, come out.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include "core/mapping/height_map.h"
#include "core/mapping/shading.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// How heights are turned into pixels.
struct HeightStyle {
    mapping::HeightRange range;
    MapOrientation orientation = MapOrientation::XUp;
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

/// Double-buffered: one worker renders all changed pages together, and they are swapped in together, so that a new
/// height range never shows next to the old one. While a batch is rendered, changes collect for the next one. Belongs
/// to the GUI thread; the worker only sees copies and immutable tiles.
class HeightLayer : public QObject {
    Q_OBJECT
public:
    explicit HeightLayer(QObject* parent = nullptr);
    /// Waits for the worker.
    ~HeightLayer() override;

    /// Removes all tiles and pictures; later tiles have cells of this size, in meters.
    void clear(double cell_size_m);
    /// Adds tiles; a new tile replaces the one with the same index. A changed range recolors every page. Nothing is
    /// rendered before the first range is known; nullopt leaves the range unchanged.
    void take(const std::vector<std::shared_ptr<const mapping::HeightTile>>& tiles,
              const std::optional<mapping::HeightRange>& range);
    /// Renders every page again.
    void setOrientation(MapOrientation orientation);

    /// Side of a cell in meters.
    double cellSize_m() const { return cell_size_m_; }
    const HeightStyle& style() const { return style_; }
    /// True until the first tile arrives, whether or not it has been rendered.
    bool empty() const { return tiles_.empty(); }
    /// Finished pictures by page index.
    const std::map<mapping::GridIndex, PagePicture>& pages() const { return pages_; }
    /// Extent of all tiles in meters of the map frame; empty without tiles.
    Rectangle bounds_in_map() const;
    /// Data of the cell at that point; nullopt if its height is unknown.
    std::optional<mapping::HeightProbe> probe(const Vec2& point_in_map_m) const;
    /// True while a worker renders or changes wait for it.
    bool busy() const { return rendering_ || !dirty_.empty(); }

signals:
    /// Finished pictures were swapped in, or all were removed.
    void changed();

private:
    /// Changes one part of the style; every page must be rendered again if that is another value.
    template <class Value>
    void restyle(Value HeightStyle::*part, const Value& value);
    /// Hands all dirty pages to the worker, unless it is busy or no range is known yet.
    void renderNext();
    /// Takes the worker's result; a result from before the last clear() is dropped.
    void swapIn(std::vector<std::pair<mapping::GridIndex, PagePicture>> finished, int generation);

    double cell_size_m_ = 0.25;
    HeightStyle style_;
    /// False until the first range arrives.
    bool range_known_ = false;
    mapping::HeightTiles tiles_;
    std::map<mapping::GridIndex, PageTiles> sources_;
    std::map<mapping::GridIndex, PagePicture> pages_;
    /// Pages that must be rendered.
    std::set<mapping::GridIndex> dirty_;
    bool rendering_ = false;
    /// Number of calls of clear().
    int generation_ = 0;
    QThreadPool pool_;
};

} // namespace usar::widgets
