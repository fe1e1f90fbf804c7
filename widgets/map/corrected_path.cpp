#include "widgets/map/corrected_path.h"

#include <algorithm>
#include <cmath>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double corrected_strip_px = 3.5; ///< width of the background below the dashes
constexpr double corrected_line_px = 1.5;
constexpr double corrected_dash_px = 9.0;
constexpr double corrected_period_px = 14.0; ///< of a dash with the gap behind it
constexpr double least_apart_px = 1.5;       ///< between two points that are both drawn
constexpr double most_apart_px = 1e4;        ///< Nobody flew from one to the other.

/// Separate segments, because one long polyline takes much longer.
struct DashedStrokes {
    QVector<QLineF> strip;
    QVector<QLineF> dashes;
    double phase_px = 0.0; ///< of the dashes at the end of the line so far

    void add(const QLineF& line);
    void pass(double length_px) { phase_px = std::fmod(phase_px + length_px, corrected_period_px); }
    void paint(QPainter& painter) const;
};

void DashedStrokes::add(const QLineF& line) {
    strip << line;
    const double length = line.length();
    for (double at = 0.0; at < length;) {
        const bool in_dash = phase_px < corrected_dash_px;
        const double step = std::min((in_dash ? corrected_dash_px : corrected_period_px) - phase_px, length - at);
        if (in_dash)
            dashes << QLineF(line.pointAt(at / length), line.pointAt((at + step) / length));
        at += step;
        phase_px = phase_px + step < corrected_period_px ? phase_px + step : 0.0;
    }
}

void DashedStrokes::paint(QPainter& painter) const {
    painter.setPen(QPen(tokens().background, corrected_strip_px, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(strip);
    painter.setPen(QPen(tokens().text, corrected_line_px, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(dashes);
}

} // namespace

void paintCorrectedPath(QPainter& painter, const std::vector<Vec2>& points_m, const MapTransform& transform,
                        const QRectF& sight_px) {
    if (points_m.size() < 2)
        return;
    DashedStrokes strokes;
    QPointF last = transform.toScreen(points_m.front());
    for (std::size_t i = 1; i < points_m.size(); ++i) {
        const QLineF line(last, transform.toScreen(points_m[i]));
        const double length_px = line.length();
        if (i + 1 < points_m.size() && length_px < least_apart_px)
            continue;
        if (length_px < most_apart_px &&
            QRectF(line.p1(), line.p2()).normalized().adjusted(-1.0, -1.0, 1.0, 1.0).intersects(sight_px))
            strokes.add(line);
        else
            strokes.pass(length_px);
        last = line.p2();
    }
    strokes.paint(painter);
}

void paintCorrectedSwatch(QPainter& painter, const QPointF& center_px) {
    constexpr QPointF end_px(9.5, 0.0); // As wide as a mark's row has room for.
    constexpr QPointF gap_px(2.5, 0.0);
    DashedStrokes strokes;
    strokes.strip << QLineF(center_px - end_px, center_px + end_px);
    strokes.dashes << QLineF(center_px - end_px, center_px - gap_px) << QLineF(center_px + gap_px, center_px + end_px);
    strokes.paint(painter);
}

} // namespace usar::widgets
