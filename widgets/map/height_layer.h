// The scan preview of the thesis (4.2) as the map's height layer: tiles go in; finished pictures of pages come out.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "widgets/map/page_picture.h"

namespace usar::widgets {

using mapping::HeightLook;

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
    const mapping::HeightTiles& tiles() const { return tiles_; }
    /// Finished pictures by page index.
    const std::map<mapping::GridIndex, PagePicture>& pages() const { return pages_; }
    Rectangle bounds_in_map() const; ///< of all tiles, in meters; empty without tiles
    /// Data of the cell at that point; nullopt if its height is unknown.
    std::optional<mapping::HeightProbe> probe(const Vec2& point_in_map_m) const;
    std::optional<mapping::HeightRange> rangeWithin(const Rectangle& area_in_map) const; ///< as mapping::rangeWithin
    bool busy() const { return rendering_ || !dirty_px_.empty(); } ///< a worker renders, or changes wait for it

signals:
    /// Finished pictures were swapped in, all were removed, or the look has changed.
    void changed();
    /// At once, and not only when they are painted: these tiles are new or other ones.
    void tilesTaken(const std::vector<std::shared_ptr<const usar::mapping::HeightTile>>& tiles);
    void cleared(); ///< all tiles were removed
    /// Before `changed`: this part of the ground is painted differently from now on.
    void groundChanged(const usar::Rectangle& in_map);

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
    /// The worker's result.
    struct Finished {
        std::vector<std::pair<mapping::GridIndex, PagePicture>> pages;
        Rectangle ground_in_map; ///< looks different from now on
        int generation;          ///< counts how often the tiles were cleared before
    };
    /// Takes a result; one from before the last clear() is dropped.
    void swapIn(Finished finished);
    void takeTile(const std::shared_ptr<const mapping::HeightTile>& tile);

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
    /// Pages that must be rendered, and the pixels of their finest picture that have changed.
    std::map<mapping::GridIndex, QRect> dirty_px_;
    bool rendering_ = false;
    /// Number of calls of clear().
    int generation_ = 0;
    QThreadPool pool_;
};

} // namespace usar::widgets
