// Objects of the world as the map paints them.
#include <cmath>

#include "widgets/map/map_painter.h"

namespace usar::widgets {

void paintObjectSymbol(QPainter& painter, const QPolygonF& outline, bool selected) {
    const Tokens& t = tokens();
    painter.setPen(QPen(t.background, 3.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
    painter.setPen(
        QPen(selected ? t.accent : t.text, selected ? 2.0 : 1.25, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(faded(selected ? t.accent : t.text_muted, 0.45));
    painter.drawPolygon(outline);
}

void MapPainter::paintObjects() {
    painter_.setRenderHint(QPainter::Antialiasing);
    const ObjectsOnMap& things = content_.objects;
    const MapObject* selected = nullptr;
    for (const MapObject& object : things.objects)
        if (object.name == things.selected)
            selected = &object;
        else
            paintObject(object, false);
    if (selected) { // Above its neighbors.
        paintWaypoints(*selected);
        paintObject(*selected, true);
    }
    painter_.setOpacity(0.6);
    for (const MapObject& object : things.objects)
        if (object.name == things.held)
            paintObject(movedTo(object, things.held_to_m), true);
    if (things.ghost)
        paintObject(*things.ghost, true);
}

void MapPainter::paintObject(const MapObject& object, bool selected) {
    const QPolygonF outline = outlineOnScreen(object, transform_);
    const QRectF bounds = outline.boundingRect();
    if (!bounds.adjusted(-80.0, -8.0, 80.0, 24.0).intersects(QRectF(QPointF(), transform_.viewport)))
        return;
    paintObjectSymbol(painter_, outline, selected);
    const QPointF center = bounds.center();
    if (object.carries) { // Arrow in the direction of the belt.
        const Vec3 along = object.body_in_map * Vec3(0.35 * object.size_m.x(), 0.0, 0.0);
        const QPointF tip = transform_.toScreen(Vec2(along.head<2>()));
        painter_.drawLine(2.0 * center - tip, tip);
        const double turn = std::atan2(tip.y() - center.y(), tip.x() - center.x());
        for (const double side : {2.6, -2.6})
            painter_.drawLine(tip, tip + 5.0 * QPointF(std::cos(turn + side), std::sin(turn + side)));
    }
    if (!selected)
        return;
    const QSizeF size(QFontMetricsF(themeFont(FontRole::Small, QFont::DemiBold)).horizontalAdvance(object.name) + 10.0,
                      18.0);
    paintLabel(QRectF(QPointF(center.x() - size.width() / 2.0, bounds.top() - gap::tiny - size.height()), size),
               object.name, true);
}

void MapPainter::paintWaypoints(const MapObject& object) {
    QPointF from = transform_.toScreen(Vec2(object.body_in_map.position_m.head<2>()));
    const QPen dashed = dashedPen(tokens_.accent, 1.5, {3.0, 3.0});
    painter_.setFont(themeFont(FontRole::Small, QFont::DemiBold));
    int number = 0;
    for (const Vec2& point_m : object.waypoints_in_map_m) {
        const QPointF at = transform_.toScreen(point_m);
        painter_.setPen(dashed);
        painter_.drawLine(from, at);
        painter_.setPen(QPen(tokens_.accent, 1.5));
        painter_.setBrush(tokens_.background);
        painter_.drawEllipse(at, 8.0, 8.0);
        painter_.setPen(tokens_.text);
        painter_.drawText(QRectF(at - QPointF(8.0, 8.0), QSizeF(16.0, 16.0)), Qt::AlignCenter,
                          QString::number(++number));
        from = at;
    }
}

} // namespace usar::widgets
