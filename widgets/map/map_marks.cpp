#include <QPainterPath>

#include "widgets/map/map_painter.h"

namespace usar::widgets {

QString layerName(MapLayer layer) {
    static constexpr std::array<const char*, map_layer_count> names = {
        "World",      "Grid",           "Height map",  "Contours", "Mission area",   "Lanes",
        "Trails",     "Corrected path", "Trace marks", "Marks",    "Trees, objects", "Start poses",
        "Laser hits", "Goals",          "Radio links", "Robots"};
    return QLatin1String(names[static_cast<std::size_t>(layer)]);
}

LayerStates firstLayers() {
    LayerStates layers;
    layers[static_cast<std::size_t>(MapLayer::World)].opacity = 0.4;
    for (const MapLayer on_request : {MapLayer::Contours, MapLayer::Radio}) // Users who need them turn them on.
        layers[static_cast<std::size_t>(on_request)].visible = false;
    return layers;
}

namespace {

QPainterPath markShape(agent::MarkShape kind, double r) {
    QPainterPath shape;
    switch (kind) {
    case agent::MarkShape::Dot:
        shape.addEllipse(QPointF(), 0.5 * r, 0.5 * r);
        break;
    case agent::MarkShape::Diamond:
        shape.addPolygon(QPolygonF({{0, -r}, {r, 0}, {0, r}, {-r, 0}, {0, -r}}));
        break;
    case agent::MarkShape::Disc:
        shape.addEllipse(QPointF(), 0.7 * r, 0.7 * r);
        break;
    case agent::MarkShape::Triangle:
        shape.addPolygon(QPolygonF({{0, -r}, {r, 0.8 * r}, {-r, 0.8 * r}, {0, -r}}));
        break;
    case agent::MarkShape::Square:
        shape.addRect(-r, -r, 2 * r, 2 * r);
        break;
    case agent::MarkShape::Ring: // The inner circle is a hole.
        shape.addEllipse(QPointF(), r, r);
        shape.addEllipse(QPointF(), 0.5 * r, 0.5 * r);
        break;
    case agent::MarkShape::Cross:
        shape.addPolygon(QPolygonF({{-r, -r},
                                    {0, -0.35 * r},
                                    {r, -r},
                                    {0.35 * r, 0},
                                    {r, r},
                                    {0, 0.35 * r},
                                    {-r, r},
                                    {-0.35 * r, 0},
                                    {-r, -r}}));
        break;
    }
    return shape;
}

} // namespace

void paintMark(QPainter& painter, agent::MarkKind kind, const QPointF& center_px, double size_px) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(center_px);
    painter.setPen(QPen(QColor(0, 0, 0, 200), 1.0));
    painter.setBrush(markColor(kind));
    painter.drawPath(markShape(agent::styleOf(kind).shape, size_px / 2.0));
    painter.restore();
}

void paintStartPoseSymbol(QPainter& painter, double turn_rad, bool hot) {
    const Tokens& t = tokens();
    const double r = symbol::diamond_px + (hot ? 2.0 : 0.0);
    const double tip = r + symbol::arrow_px;
    painter.save();
    painter.rotate(degrees(turn_rad));
    painter.setPen(QPen(t.text, 1.5));
    painter.drawLine(QPointF(0.0, -r), QPointF(0.0, -tip + 4.0));
    painter.setBrush(t.text);
    painter.drawPolygon(QPolygonF({{0.0, -tip}, {-3.5, -tip + 7.0}, {3.5, -tip + 7.0}}));
    painter.restore();
    painter.setPen(QPen(t.text, 1.5));
    painter.setBrush(hot ? t.accent : t.raised);
    painter.drawPolygon(QPolygonF({{0.0, -r}, {r, 0.0}, {0.0, r}, {-r, 0.0}}));
}

void paintRobotSymbol(QPainter& painter, double turn_rad, const QColor& color, bool stale) {
    const double r = symbol::robot_px;
    painter.save();
    painter.rotate(degrees(turn_rad));
    painter.setPen(QPen(stale ? tokens().stale : inkOn(color), 1.5));
    painter.setBrush(stale ? tokens().background : color);
    painter.drawPolygon(QPolygonF({{0.0, -r}, {0.75 * r, 0.8 * r}, {0.0, 0.4 * r}, {-0.75 * r, 0.8 * r}}));
    painter.restore();
}

void paintStationSymbol(QPainter& painter, const QColor& color, bool stale) {
    const double r = symbol::robot_px;
    painter.setPen(QPen(stale ? tokens().stale : inkOn(color), 1.5));
    painter.setBrush(stale ? tokens().background : color);
    painter.drawPolygon(QPolygonF({{0.0, -0.6 * r}, {0.6 * r, r}, {-0.6 * r, r}}));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(stale ? tokens().stale : color, 2.0));
    for (const double reach : {0.55 * r, 0.95 * r}) { // Waves to the left and right of the mast's tip.
        const QRectF around(-reach, -0.6 * r - reach, 2.0 * reach, 2.0 * reach);
        painter.drawArc(around, -45 * 16, 90 * 16);
        painter.drawArc(around, 135 * 16, 90 * 16);
    }
}

QSizeF chipSize(const QString& text) {
    const QFontMetricsF metrics(themeFont(FontRole::Small));
    return {metrics.horizontalAdvance(text) + 2.0 * gap::small, metrics.height() + gap::small};
}

QRectF paintChip(QPainter& painter, const QPointF& at_px, const QString& text, Qt::Alignment alignment) {
    painter.save();
    painter.setFont(themeFont(FontRole::Small));
    const QSizeF size = chipSize(text);
    QRectF chip(at_px, size);
    if (alignment & Qt::AlignRight)
        chip.moveRight(at_px.x());
    if (alignment & Qt::AlignHCenter)
        chip.moveLeft(at_px.x() - size.width() / 2.0);
    if (alignment & Qt::AlignBottom)
        chip.moveBottom(at_px.y());
    painter.setRenderHint(QPainter::Antialiasing);
    paintCard(painter, chip);
    painter.setPen(tokens().text);
    painter.drawText(chip, Qt::AlignCenter, text);
    painter.restore();
    return chip;
}

} // namespace usar::widgets
