#include "widgets/map/map_overlay.h"

#include <cmath>
#include <set>

#include "widgets/map/map_painter.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

constexpr double edge = gap::medium;

void paintScaleBar(QPainter& painter, const MapTransform& transform) {
    const Tokens& t = tokens();
    const double length_m = roundStep(160.0 / transform.pixels_per_m);
    const double length_px = length_m * transform.pixels_per_m;
    const double y = transform.viewport.height() - edge;
    const QString text =
        length_m >= 1000.0 ? QStringLiteral("%1 km").arg(length_m / 1000.0) : QStringLiteral("%1 m").arg(length_m);
    for (const auto& [ink, width] : {std::pair(t.background, 5.0), std::pair(t.text, 2.0)}) {
        painter.setPen(QPen(ink, width));
        painter.drawPolyline(
            QPolygonF({{edge, y - 6.0}, {edge, y}, {edge + length_px, y}, {edge + length_px, y - 6.0}}));
    }
    paintChip(painter, QPointF(edge + length_px / 2.0, y - 10.0), text, Qt::AlignHCenter | Qt::AlignBottom);
}

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& by, const QString& name, const QColor& ink) {
    painter.setPen(QPen(ink, 2.0));
    painter.drawLine(from, from + by);
    const QPointF along = by / std::hypot(by.x(), by.y());
    const QPointF across(-along.y(), along.x());
    painter.setBrush(ink);
    painter.drawPolygon(QPolygonF({from + by + along * 6.0, from + by + across * 4.0, from + by - across * 4.0}));
    const QPointF middle = from + by + along * 15.0;
    painter.drawText(QRectF(middle.x() - 8.0, middle.y() - 9.0, 16.0, 18.0), Qt::AlignCenter, name);
}

QPointF axesOrigin(const MapTransform& transform) {
    return {transform.viewport.width() - edge - 24.0, edge + 56.0};
}

/// Paints the x and y axes of the map frame, so that "up" is defined without pretending to know north.
void paintAxes(QPainter& painter, const MapTransform& transform) {
    const Tokens& t = tokens();
    const QPointF origin = axesOrigin(transform);
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(t.background, 0.7));
    painter.drawEllipse(axesGlass_px(transform));
    painter.setFont(themeFont(FontRole::Small, QFont::DemiBold));
    const bool x_up = transform.orientation == MapOrientation::XUp;
    paintArrow(painter, origin, QPointF(0.0, -28.0), x_up ? QStringLiteral("x") : QStringLiteral("y"), t.text);
    paintArrow(painter, origin, QPointF(x_up ? -28.0 : 14.0, 0.0), x_up ? QStringLiteral("y") : QStringLiteral("x"),
               t.text_muted);
}

/// Paints the color scale with the lowest and highest height; returns the top edge of the legend.
double paintHeightLegend(QPainter& painter, const HeightLayer& heights, const QPointF& bottom_right) {
    const Tokens& t = tokens();
    const mapping::HeightRange& range = heights.style().range;
    const QRectF box(bottom_right.x() - 224.0, bottom_right.y() - 48.0, 224.0, 48.0);
    paintCard(painter, box);
    const QRectF bar = box.adjusted(gap::small, 26.0, -gap::small, -gap::small);
    const int steps = static_cast<int>(bar.width());
    for (int i = 0; i < steps; ++i) {
        const float part = static_cast<float>(i) / static_cast<float>(steps - 1);
        const float height_m = range.minimum_m + part * (range.maximum_m - range.minimum_m);
        painter.fillRect(QRectF(bar.left() + i, bar.top(), 1.0, bar.height()),
                         QColor::fromRgba(mapping::shade(height_m, range, mapping::ColorMap::Gray)));
    }
    painter.setFont(themeFont(FontRole::Small));
    const QRectF words = box.adjusted(gap::small, 4.0, -gap::small, -24.0);
    painter.setPen(t.text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, figure(double(range.minimum_m), 1));
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     figure(double(range.maximum_m), 1) + QStringLiteral(" m"));
    painter.setPen(t.text_muted);
    painter.drawText(words, Qt::AlignCenter, QStringLiteral("height"));
    return box.top();
}

/// Paints the kinds of marks that are on the map with their names; returns the top edge of the legend.
double paintMarkLegend(QPainter& painter, const std::vector<agent::MapMark>& marks, const QPointF& bottom_right) {
    std::set<agent::MarkKind> present;
    for (const agent::MapMark& mark : marks)
        present.insert(mark.kind);
    const double row = 20.0;
    const double height = row * static_cast<double>(present.size()) + gap::small;
    const QRectF box(bottom_right.x() - 124.0, bottom_right.y() - height, 124.0, height);
    paintCard(painter, box);
    painter.setFont(themeFont(FontRole::Small));
    double y = box.top() + gap::tiny;
    for (const agent::MarkKind kind : present) {
        paintMark(painter, kind, QPointF(box.left() + 16.0, y + row / 2.0), 10.0);
        painter.setPen(tokens().text);
        painter.drawText(QRectF(box.left() + 30.0, y, box.width() - 34.0, row), Qt::AlignVCenter, markName(kind));
        y += row;
    }
    return box.top();
}

} // namespace

QString probeText(const Vec2& point_in_map_m, const std::optional<mapping::HeightProbe>& ground) {
    return QStringLiteral("x %1   y %2   z %3 m   hits %4")
        .arg(figure(point_in_map_m.x(), 1, 6), figure(point_in_map_m.y(), 1, 6),
             ground ? figure(double(ground->height_m), 2, 6) : figure(qQNaN(), 2, 6),
             figure(ground ? double(ground->hits) : qQNaN(), 0, 3));
}

QRectF axesGlass_px(const MapTransform& transform) {
    return {axesOrigin(transform) + QPointF(-56.0, -60.0), QSizeF(88.0, 88.0)};
}

void paintOverlay(QPainter& painter, const MapOverlay& overlay, const MapContent& content, const HeightLayer& heights,
                  const MapTransform& transform) {
    painter.setRenderHint(QPainter::Antialiasing);
    paintScaleBar(painter, transform);
    paintAxes(painter, transform);
    const double right = transform.viewport.width() - edge;
    double bottom = transform.viewport.height() - edge;
    if (!heights.empty() && content.layer(MapLayer::Heights).visible)
        bottom = paintHeightLegend(painter, heights, QPointF(right, bottom)) - gap::small;
    if (!overlay.probe.isEmpty())
        bottom = paintChip(painter, QPointF(right, bottom), overlay.probe, Qt::AlignRight | Qt::AlignBottom).top() -
                 gap::small;
    if (!content.marks.empty() && content.layer(MapLayer::Marks).visible)
        paintMarkLegend(painter, content.marks, QPointF(right, bottom));
    if (!overlay.following.isEmpty())
        paintChip(painter, QPointF(transform.viewport.width() / 2.0, edge),
                  QStringLiteral("Following %1 — drag the map to stop").arg(overlay.following), Qt::AlignHCenter);
    if (overlay.focused) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tokens().accent, 2.0));
        painter.drawRect(QRectF(QPointF(1.0, 1.0), transform.viewport - QSizeF(2.0, 2.0)));
    }
}

} // namespace usar::widgets
