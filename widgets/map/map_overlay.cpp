#include "widgets/map/map_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QCoreApplication>

#include "widgets/map/map_painter.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

constexpr double edge = gap::medium;
constexpr double longest_bar_px = 160.0;
constexpr double scale_bar_px = 40.0; ///< height of the bar with its text
constexpr double whole_legend_px = 224.0;
constexpr double least_legend_px = 120.0; ///< of the height legend, which has room for its figures only
constexpr double legend_row_px = 20.0;

void paintScaleBar(QPainter& painter, const MapTransform& transform) {
    const Tokens& t = tokens();
    const double length_m = roundStep(longest_bar_px / transform.pixels_per_m);
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

/// Where the axes meet, so that arrows and letters lie in the middle of their glass.
QPointF axesOrigin(const MapTransform& transform) {
    const bool x_up = transform.orientation == MapOrientation::XUp;
    return axesGlass_px(transform).center() + (x_up ? QPointF(19.0, 19.0) : QPointF(-12.0, 19.0));
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

/// Paints the color scale with the lowest and highest height, in the colors of the height layer.
void paintHeightLegend(QPainter& painter, const HeightLayer& heights, bool contours, const QRectF& box) {
    const Tokens& t = tokens();
    const mapping::HeightRange range = heights.range();
    paintCard(painter, box);
    const QRectF bar = box.adjusted(gap::small, 26.0, -gap::small, -gap::small);
    const auto last = static_cast<float>(bar.width() - 1.0);
    for (float i = 0.0f; i <= last; ++i)
        painter.fillRect(QRectF(bar.left() + double(i), bar.top(), 1.0, bar.height()),
                         QColor::fromRgba(mapping::shade(i, {0.0f, last}, heights.style().color_map)));
    painter.setFont(themeFont(FontRole::Small));
    const QRectF words = box.adjusted(gap::small, 4.0, -gap::small, -24.0);
    painter.setPen(t.text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, figure(double(range.minimum_m), 1));
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     figure(double(range.maximum_m), 1) + QStringLiteral(" m"));
    painter.setPen(t.text_muted);
    if (box.width() < whole_legend_px)
        return;
    painter.drawText(words, Qt::AlignCenter,
                     contours ? QStringLiteral("lines every %1 m").arg(contourStep_m(range))
                              : QStringLiteral("height"));
}

/// The kinds of which there is a mark. Runs in every frame, over thousands of marks.
std::vector<agent::MarkKind> kindsOf(const MapContent& content) {
    std::array<bool, agent::all_mark_kinds.size()> present{};
    for (const auto& [robot, marks] : content.marks)
        for (const agent::MapMark& mark : marks)
            present[static_cast<std::size_t>(mark.kind)] = true;
    std::vector<agent::MarkKind> kinds;
    for (const agent::MarkKind kind : agent::all_mark_kinds)
        if (present[static_cast<std::size_t>(kind)])
            kinds.push_back(kind);
    return kinds;
}

bool showsCorrectedPath(const MapContent& content) {
    return content.layer(MapLayer::Corrected).visible && std::ranges::any_of(content.robots, [](const auto& entry) {
               return entry.second.corrected_in_map_m != nullptr;
           });
}

/// Paints the kinds of marks that are on the map with their names, and the corrected path if there is one.
void paintMarkLegend(QPainter& painter, const MapContent& content, const Legends& legends, const QRectF& box) {
    paintCard(painter, box);
    painter.setFont(themeFont(FontRole::Small));
    QPointF middle(box.left() + 16.0, box.top() + gap::tiny + legend_row_px / 2.0);
    const auto endRow = [&](const QString& name) {
        painter.setPen(tokens().text);
        painter.drawText(QRectF(box.left() + 30.0, middle.y() - legend_row_px / 2.0, box.width() - 34.0, legend_row_px),
                         Qt::AlignVCenter, name);
        middle.ry() += legend_row_px;
    };
    if (legends.mark_kinds > 0)
        for (const agent::MarkKind kind : kindsOf(content)) {
            paintMark(painter, kind, middle, 10.0);
            endRow(markName(kind));
        }
    if (legends.corrected_path) {
        paintCorrectedSwatch(painter, middle);
        endRow(layerName(MapLayer::Corrected));
    }
}

} // namespace

QString probeText(const Vec2& point_in_map_m, const std::optional<mapping::HeightProbe>& ground,
                  const QStringList& scanned_by, std::optional<Seconds> age) {
    const QString whose = scanned_by.isEmpty() ? QString() : QStringLiteral("   by ") + scanned_by.join(", ");
    const QString when = age ? QCoreApplication::translate("MapOverlay", "   %1 ago").arg(ageText(*age)) : QString();
    return QStringLiteral("x %1   y %2   z %3 m   hits %4")
               .arg(figure(point_in_map_m.x(), 1, 6), figure(point_in_map_m.y(), 1, 6),
                    ground ? figure(double(ground->height_m), 2, 6) : figure(qQNaN(), 2, 6),
                    figure(ground ? double(ground->hits) : qQNaN(), 0, 3)) +
           when + whose;
}

QRectF axesGlass_px(const MapTransform& transform) {
    constexpr double across_px = 88.0;
    return {transform.viewport.width() - gap::small - across_px, gap::small, across_px, across_px};
}

Legends legendsOf(const MapContent& content, const HeightLayer& heights) {
    return {!heights.empty() && content.layer(MapLayer::Heights).visible,
            content.layer(MapLayer::Marks).visible ? kindsOf(content).size() : 0, showsCorrectedPath(content)};
}

Legends legendsOfAMission(const MapContent& content) {
    return {content.layer(MapLayer::Heights).visible,
            content.layer(MapLayer::Marks).visible ? agent::all_mark_kinds.size() : 0, showsCorrectedPath(content)};
}

OverlayPlaces::OverlayPlaces(const Legends& legends, const MapTransform& transform) : axes(axesGlass_px(transform)) {
    const QSizeF view = transform.viewport;
    scale_bar = QRectF(edge, view.height() - edge - scale_bar_px, longest_bar_px, scale_bar_px);
    QPointF corner(view.width() - edge, view.height() - edge);
    if (legends.heights) {
        const QSizeF size(std::clamp(std::round(0.35 * view.width()), least_legend_px, whole_legend_px), 48.0);
        heights = QRectF(corner - QPointF(size.width(), size.height()), size);
        corner.setY(heights.top() - gap::small);
    }
    constexpr double most = 1.0 / 12.0; // A larger part of the view belongs to the map.
    const std::size_t rows = legends.mark_kinds + (legends.corrected_path ? 1 : 0);
    const QSizeF size(124.0, legend_row_px * static_cast<double>(rows) + gap::small);
    if (rows > 0 && size.width() * size.height() <= most * view.width() * view.height())
        marks = QRectF(corner - QPointF(size.width(), size.height()), size);
}

std::vector<QRectF> OverlayPlaces::all() const {
    std::vector<QRectF> places;
    for (const QRectF& place : {axes, scale_bar, heights, marks})
        if (!place.isEmpty())
            places.push_back(place);
    return places;
}

QRectF probePlace(const QString& probe, const OverlayPlaces& places, const MapTransform& transform) {
    double bottom = transform.viewport.height() - edge;
    for (const QRectF& legend : {places.heights, places.marks})
        if (!legend.isEmpty())
            bottom = legend.top() - gap::small;
    const QSizeF size = chipSize(probe);
    return {QPointF(transform.viewport.width() - edge - size.width(), bottom - size.height()), size};
}

void paintOverlay(QPainter& painter, const MapOverlay& overlay, const MapContent& content, const HeightLayer& heights,
                  const MapTransform& transform, const QRectF& part_px) {
    painter.setRenderHint(QPainter::Antialiasing);
    const Legends legends = legendsOf(content, heights);
    const OverlayPlaces places(legends, transform);
    const auto touched = [&](const QRectF& place) {
        return !place.isEmpty() && place.adjusted(-edge, -edge, edge, edge).intersects(part_px);
    };
    if (touched(places.scale_bar))
        paintScaleBar(painter, transform);
    if (touched(places.axes))
        paintAxes(painter, transform);
    if (touched(places.heights))
        paintHeightLegend(painter, heights, content.layer(MapLayer::Contours).visible, places.heights);
    if (touched(places.marks))
        paintMarkLegend(painter, content, legends, places.marks);
    if (!overlay.probe.isEmpty())
        paintChip(painter, probePlace(overlay.probe, places, transform).topLeft(), overlay.probe, {});
    if (!overlay.following.isEmpty())
        paintChip(painter, QPointF(transform.viewport.width() / 2.0, edge),
                  QStringLiteral("Following %1 — drag the map to stop").arg(overlay.following), Qt::AlignHCenter);
    if (overlay.focused)
        frameInStrips(painter, QRectF(QPointF(), transform.viewport), 2.0, tokens().accent);
}

} // namespace usar::widgets
