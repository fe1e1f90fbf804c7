#include "widgets/map/measure_painter.h"

#include <algorithm>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double plot_height_px = 64.0;

void paintLine(QPainter& painter, const QPointF& from, const QPointF& to) {
    const Tokens& t = tokens();
    for (const QPen& pen : {QPen(t.background, 4.0), QPen(t.accent, 1.5)}) {
        painter.setPen(pen);
        painter.setBrush(t.surface);
        painter.drawLine(from, to);
        for (const QPointF& end : {from, to})
            painter.drawEllipse(end, 4.0, 4.0);
    }
}

void paintOutline(QPainter& painter, const QRectF& rectangle) {
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(tokens().background, 4.0), QPen(tokens().accent, 1.5)}) {
        painter.setPen(pen);
        painter.drawRect(rectangle);
    }
}

/// Paints the curve into the box: lowest height at its bottom, highest at its top.
void paintCurve(QPainter& painter, const QRectF& box, const LineProfile& profile) {
    const auto range = profile.range_m();
    if (!range)
        return;
    const double span_m = std::max(range->second - range->first, 1e-3);
    const double step_px = box.width() / static_cast<double>(profile.heights_m.size() - 1);
    QPolygonF piece;
    const auto flush = [&] {
        painter.drawPolyline(piece);
        piece.clear();
    };
    painter.setPen(QPen(tokens().accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < profile.heights_m.size(); ++i)
        if (const auto& height_m = profile.heights_m[i])
            piece << QPointF(box.left() + static_cast<double>(i) * step_px,
                             box.bottom() - (*height_m - range->first) / span_m * box.height());
        else
            flush();
    flush();
}

} // namespace

LineProfile profileOf(const MeasuredLine& line, const HeightLayer& heights) {
    return profileOf(line, heights.cellSize_m(), [&heights](const Vec2& at_m) -> std::optional<double> {
        const auto probe = heights.probe(at_m);
        return probe ? std::optional(static_cast<double>(probe->height_m)) : std::nullopt;
    });
}

QString measuredText(const MeasuredLine& line, const HeightLayer& heights) {
    if (!line.spans_rectangle)
        return profileText(profileOf(line, heights));
    const Rectangle rectangle = line.rectangle_in_map();
    const auto range = heights.rangeWithin(rectangle);
    return rectangleText(rectangle, range ? std::optional(std::pair<double, double>(range->minimum_m, range->maximum_m))
                                          : std::nullopt);
}

void paintMeasured(QPainter& painter, const MeasuredLine& line, const HeightLayer& heights,
                   const MapTransform& transform) {
    const LineProfile profile = line.spans_rectangle ? LineProfile{} : profileOf(line, heights);
    const bool known = profile.range_m().has_value();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (line.spans_rectangle)
        paintOutline(painter, transform.toScreen(line.rectangle_in_map()));
    else
        paintLine(painter, transform.toScreen(line.from_m), transform.toScreen(line.to_m));
    const Tokens& t = tokens();
    painter.setFont(themeFont());
    const QString text = measuredText(line, heights);
    const QFontMetricsF metrics(painter.font());
    const double width_px = std::max(metrics.horizontalAdvance(text), 240.0) + 2.0 * gap::small;
    const double height_px = metrics.height() + 2.0 * gap::tiny + (known ? plot_height_px + gap::small : 0.0);
    const QRectF sheet((transform.viewport.width() - width_px) / 2.0, gap::small, width_px, height_px);
    painter.setPen(QPen(t.line, 1.0));
    painter.setBrush(t.surface);
    painter.drawRoundedRect(sheet, 4.0, 4.0);
    const QRectF inner = sheet.adjusted(gap::small, gap::tiny, -gap::small, -gap::tiny);
    painter.setPen(t.text);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, text);
    paintCurve(painter, QRectF(inner.left(), inner.bottom() - plot_height_px, inner.width(), plot_height_px - 2.0),
               profile);
    painter.restore();
}

} // namespace usar::widgets
