// The legend below a map picture: explains the colors of heights, lengths and the marks.
#pragma once

#include <optional>

#include <QPointF>
#include <QRect>
#include <QString>

#include "core/agent/mark_style.h"
#include "core/mapping/shading.h"

class QPainter;

namespace usar::mission {

/// Draws one mark around `center` in the color and shape that agent::styleOf gives it; `unit_px` is the radius of a
/// dot. A dark rim keeps all but path dots legible on light ground.
void drawMark(QPainter& painter, agent::MarkKind kind, const QPointF& center, double unit_px);

/// Returns the longest of 1, 2, 5, 10, 20, 50 … meters that fits into `room_px`.
double scaleBarLength_m(double pixels_per_m, double room_px);

/// Contents of the legend.
struct Legend {
    std::optional<mapping::HeightRange> range; ///< heights in meters; absent: the map is empty
    mapping::ColorMap colors = mapping::ColorMap::Color;
    double pixels_per_m = 1.0;
    QString title;
    double text_px = 14.0;

    /// Height of the strip that this legend needs at this width.
    int heightFor(int width_px) const;
    /// Draws into `strip`, whose height should come from heightFor().
    void draw(QPainter& painter, const QRect& strip) const;
};

} // namespace usar::mission
