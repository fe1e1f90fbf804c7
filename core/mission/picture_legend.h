// The strip below a map picture: what the grays, the lengths and the colored marks mean.
#pragma once

#include <optional>

#include <QColor>
#include <QPointF>
#include <QRect>
#include <QString>

#include "core/agent/published.h"
#include "core/mapping/height_map.h"

class QPainter;

namespace usar::mission {

/// How a kind of mark looks, in the thesis's colors.
struct MarkStyle {
    QColor color;
    QString label;
};
MarkStyle markStyle(agent::MarkKind kind);

/// One mark around `center`: dots, yellow squares for recharges, violet circles for landings, crosses for goals given
/// up; `unit_px` is the radius of a dot. A dark rim keeps it legible on light ground.
void drawMark(QPainter& painter, agent::MarkKind kind, const QPointF& center, double unit_px);

/// The longest of 1, 2, 5, 10, 20, 50 … metres that takes no more than `room_px`.
double scaleBarLength_m(double pixels_per_m, double room_px);

/// What the strip is made from. Heights in metres; a missing range is an empty map.
struct Legend {
    std::optional<mapping::HeightRange> range;
    double pixels_per_m = 1.0;
    QString title;
    double text_px = 14.0;

    /// Height of the strip that this legend needs at this width.
    int heightFor(int width_px) const;
    void draw(QPainter& painter, const QRect& strip) const;
};

} // namespace usar::mission
