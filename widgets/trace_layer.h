// What robots under TRACE left behind, baked into pictures: any number of marks costs nothing while the map is moved.
#pragma once

#include <compare>
#include <map>
#include <vector>

#include <QColor>
#include <QImage>
#include <QPainter>

#include "widgets/models/map_transform.h"

namespace usar::widgets {

/// Sparse tiles of 256 pixels at scales of powers of two, made when they are first seen. Marks that would cover each
/// other are drawn once. GUI thread.
class TraceLayer {
public:
    void add(const Vec2& point_in_map_m, const QColor& color);
    void clear();
    bool empty() const { return marks_.empty(); }
    std::size_t count() const { return marks_.size(); }
    void paint(QPainter& painter, const MapTransform& transform) const;

private:
    struct Mark {
        Vec2 point_m;
        QRgb color;
    };
    /// The tile's place counts in tiles along the screen's axes from the map's origin.
    struct Key {
        int level = 0; ///< pixels a meter: 2^level
        int column = 0;
        int row = 0;
        auto operator<=>(const Key&) const = default;
    };
    /// Along the screen's axes, in meters.
    QPointF onScreenAxes(const Vec2& point_m) const;
    QImage bake(const Key& key) const;

    std::vector<Mark> marks_;
    mutable MapOrientation orientation_ = MapOrientation::YUp; ///< of the tiles
    mutable std::map<Key, QImage> tiles_;
};

} // namespace usar::widgets
