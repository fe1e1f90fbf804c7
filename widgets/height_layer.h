// The scan preview of the thesis (4.2) as the map's height layer: tiles in, finished pictures out, never a half one.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QObject>
#include <QThreadPool>

#include "widgets/models/height_page.h"

namespace usar::widgets {

/// What is known of one cell, for the probe under the cursor.
struct HeightProbe {
    float height_m = 0.0f; ///< the array's value: the mean of what was measured
    int hits = 0;          ///< 0: made up between two beams
};

/// Double-buffered: all pages that changed are rendered together by one worker and swapped together, so that a shade
/// that follows a new range never shows two ranges at once. While a batch runs, changes collect for the next one.
/// Lives on the GUI thread; the worker sees only values.
class HeightLayer : public QObject {
    Q_OBJECT
public:
    explicit HeightLayer(QObject* parent = nullptr);
    ~HeightLayer() override;

    /// Forgets everything.
    void clear(double cell_size_m);
    /// New tiles replace old ones of the same index; a new range recolors every page.
    void take(const std::vector<std::shared_ptr<const mapping::HeightTile>>& tiles,
              const std::optional<mapping::HeightRange>& range);
    /// Both recolor every page.
    void setColorMap(mapping::ColorMap color_map);
    void setOrientation(MapOrientation orientation);

    double cellSize_m() const { return cell_size_m_; }
    const HeightStyle& style() const { return style_; }
    /// True until the first tile comes, whether or not it is rendered yet.
    bool empty() const { return tiles_.empty(); }
    /// Finished pictures by page.
    const std::map<mapping::GridIndex, PagePicture>& pages() const { return pages_; }
    /// Covers all tiles; empty without any.
    Rectangle bounds_in_map() const;
    /// Of the cell under that point; nothing where its height is unknown.
    std::optional<HeightProbe> probe(const Vec2& point_in_map_m) const;
    /// True while a worker renders or changes wait for one.
    bool busy() const { return rendering_ || !dirty_.empty(); }

signals:
    /// Finished pictures were swapped in, or all were dropped.
    void changed();

private:
    void setStyle(const HeightStyle& style);
    /// Hands all dirty pages to the worker, unless it is at work or no range is known yet.
    void renderNext();
    /// Results of an older generation (before a clear) are dropped.
    void swapIn(std::vector<std::pair<mapping::GridIndex, PagePicture>> finished, int generation);

    double cell_size_m_ = 0.25;
    HeightStyle style_;
    bool range_known_ = false;
    std::map<mapping::GridIndex, std::shared_ptr<const mapping::HeightTile>> tiles_;
    std::map<mapping::GridIndex, PageTiles> sources_;
    std::map<mapping::GridIndex, PagePicture> pages_;
    std::set<mapping::GridIndex> dirty_;
    bool rendering_ = false;
    int generation_ = 0;
    QThreadPool pool_;
};

} // namespace usar::widgets
