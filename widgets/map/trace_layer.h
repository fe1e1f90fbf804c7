// Map layer of the marks that robots leave while TRACE is on, cached as images, so that panning costs little.
#pragma once

#include <compare>
#include <map>
#include <vector>

#include <QColor>
#include <QImage>
#include <QPainter>

#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// Sparse tiles of 256 pixels at scales of powers of two, made when they first become visible. Of marks that cover each
/// other only the newest is drawn. GUI thread.
class TraceLayer {
public:
    /// Adds a mark in meters of the map frame; ignored if it is not finite.
    void add(const Vec2& point_in_map_m, const QColor& color);
    /// Removes all marks and tiles.
    void clear();
    /// Number of marks, whether visible or not.
    bool empty() const { return marks_.empty(); }
    std::size_t count() const { return marks_.size(); }
    /// Paints the visible tiles; missing ones are made first.
    void paint(QPainter& painter, const MapTransform& transform) const;

private:
    struct Mark {
        Vec2 point_m;
        QRgb color;
    };
    /// Index of a tile; columns and rows count along the screen's axes from the map's origin.
    struct Key {
        int level = 0; ///< 2^level pixels per meter
        int column = 0;
        int row = 0;
        auto operator<=>(const Key&) const = default;
    };
    /// Map point in meters along the screen's axes.
    QPointF onScreenAxes(const Vec2& point_m) const;
    /// Paints all marks of a tile.
    QImage bake(const Key& key) const;

    std::vector<Mark> marks_;
    mutable MapOrientation orientation_ = MapOrientation::YUp; ///< orientation of the cached tiles
    mutable std::map<Key, QImage> tiles_;
};

} // namespace usar::widgets
