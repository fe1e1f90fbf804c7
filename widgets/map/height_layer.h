// The scan preview of the thesis (4.2) as the map's height layer: tiles go in; finished pictures of squares of 4 x 4
// tiles, with mip levels, come out.
#pragma once

#include <array>
#include <bitset>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "core/mapping/height_look.h"
#include "core/mapping/height_map.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

using mapping::HeightLook;

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
    using Which = std::bitset<count>; ///< of the tiles

    mapping::GridIndex index; ///< in pages
    std::array<std::shared_ptr<const mapping::HeightTile>, count> tiles;
};

/// Pictures of a page: level 0 has one pixel per cell, each further level half the size. Already oriented for the
/// screen.
struct PagePicture {
    static constexpr std::size_t level_count = 4;
    using Levels = std::array<QImage, level_count>;
    Levels levels;
    Levels contours; ///< transparent but for the lines; null images if no contours are drawn

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
/// The same if `before` is the page in the same style before these tiles changed; only their part of it is rendered.
PagePicture renderAgain(const PageTiles& page, const HeightStyle& style, const PagePicture& before,
                        const PageTiles::Which& changed);

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
    ~HeightLayer() override; ///< waits for the worker

    /// Removes all tiles and pictures; later tiles have cells of this size, in meters.
    void clear(double cell_size_m);
    /// Adds tiles; a new tile replaces the one with the same index. A changed range recolors every page. Nothing is
    /// rendered before the first range is known; nullopt leaves the range unchanged.
    void take(const std::vector<std::shared_ptr<const mapping::HeightTile>>& tiles,
              const std::optional<mapping::HeightRange>& range);
    /// Each of these renders every page again if it changes something.
    void setOrientation(MapOrientation orientation);
    void setLook(const HeightLook& look);
    void setContours(bool drawn);

    double cellSize_m() const { return style_.cell_size_m; } ///< side of a cell in meters
    /// As the pages are painted; their range may differ from `range` by less than the colors can show.
    const HeightStyle& style() const { return style_; }
    /// The heights at the two ends of the color scale; without extent until they are known.
    mapping::HeightRange range() const;
    bool empty() const { return tiles_.empty(); } ///< until the first tile arrives, rendered or not
    /// Finished pictures by page index.
    const std::map<mapping::GridIndex, PagePicture>& pages() const { return pages_; }
    Rectangle bounds_in_map() const; ///< of all tiles, in meters; empty without tiles
    /// Data of the cell at that point; nullopt if its height is unknown.
    std::optional<mapping::HeightProbe> probe(const Vec2& point_in_map_m) const;
    std::optional<mapping::HeightRange> rangeWithin(const Rectangle& area_in_map) const; ///< as mapping::rangeWithin
    bool busy() const { return rendering_ || !dirty_.empty(); } ///< a worker renders, or changes wait for it

signals:
    /// Finished pictures were swapped in, all were removed, or the look has changed.
    void changed();

private:
    /// Changes one part of the style; every page must be rendered again if that is another value.
    template <class Value>
    void restyle(Value HeightStyle::*part, const Value& value);
    /// True if heights have a color: there is a scan or a fixed range.
    bool rangeKnown() const { return scan_range_ || look_.fixed_range; }
    /// Finds the range without extreme cells if the look wants it, at once or a second after the last time.
    void trim();
    /// Paints with the present range and its contours from now on, if that can be seen.
    void applyRange();
    /// Hands all dirty pages to the worker, unless it is busy or no range is known yet.
    void renderNext();
    /// Takes the worker's result; a result from before the last clear() is dropped.
    void swapIn(std::vector<std::pair<mapping::GridIndex, PagePicture>> finished, int generation);

    HeightStyle style_;
    HeightLook look_;
    bool contours_ = false;
    std::optional<mapping::HeightRange> scan_range_; ///< nullopt until the first range arrives
    std::optional<mapping::HeightRange> trimmed_range_;
    bool trim_due_ = false;
    QTimer trim_pause_; ///< runs for a second after each look at all cells
    mapping::HeightTiles tiles_;
    std::map<mapping::GridIndex, PageTiles> sources_;
    std::map<mapping::GridIndex, PagePicture> pages_;
    /// Pages that must be rendered, and their tiles that have changed.
    std::map<mapping::GridIndex, PageTiles::Which> dirty_;
    bool rendering_ = false;
    /// Number of calls of clear().
    int generation_ = 0;
    QThreadPool pool_;
};

} // namespace usar::widgets
