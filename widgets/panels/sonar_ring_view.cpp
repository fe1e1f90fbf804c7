#include "widgets/panels/sonar_ring_view.h"

#include <algorithm>
#include <cmath>

#include "widgets/models/figures.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr double thinnest_rad = radians(2.0); ///< half angle of a cone whose width is not known

Vec2 toward(double bearing_rad) {
    return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

/// A sector of a circle around the sonar, up to `range_m`.
QPolygonF sector(const auto& frame, const SonarCone& cone, double range_m) {
    const double half_rad = std::max(cone.half_angle_rad, thinnest_rad);
    QPolygonF shape{frame(cone.at_m)};
    for (int step = -6; step <= 6; ++step)
        shape << frame(cone.at_m + range_m * toward(cone.bearing_rad + half_rad * step / 6.0));
    return shape;
}

} // namespace

SonarRingView::SonarRingView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Sonars around the robot"));
    tellWhat(0.0);
}

void SonarRingView::tellWhat(double farthest_m) {
    const QString reach = farthest_m > 0.0 ? tr(", up to %1 m").arg(figure(farthest_m, 1)) : QString();
    setToolTip(tr("The sonars where they are mounted, seen from above, with what is ahead at the top. Ranges in "
                  "meters%1; a cone that is filled to its rim hears nothing.")
                   .arg(reach));
}

void SonarRingView::setRing(const SonarRing& ring) {
    if (ring == ring_)
        return;
    ring_ = ring;
    QStringList words;
    double farthest_m = 0.0;
    for (const SonarCone& cone : ring.cones) {
        words << tr("%1 %2 m").arg(QString::fromStdString(cone.name), figure(cone.range_m, 2));
        farthest_m = std::max(farthest_m, cone.maximum_m);
    }
    tellWhat(farthest_m);
    showFresh(words.isEmpty() ? tr("No places of sonars yet") : words.join(QStringLiteral(", ")));
}

SonarRingView::Frame SonarRingView::frameFor(const QRectF& room) const {
    QRectF box(-ring_.width_m / 2.0, -ring_.length_m / 2.0, ring_.width_m, ring_.length_m);
    const auto include = [&box](const Vec2& point_m) { box |= QRectF(-point_m.y(), -point_m.x(), 1e-6, 1e-6); };
    for (const SonarCone& cone : ring_.cones)
        for (const double side : {-1.0, 0.0, 1.0})
            include(cone.at_m + cone.maximum_m * toward(cone.bearing_rad + side * cone.half_angle_rad));
    const QFontMetricsF metrics(themeFont(FontRole::Small));
    const QRectF inner = room.adjusted(metrics.horizontalAdvance(QStringLiteral("0.00!")), metrics.height(),
                                       -metrics.horizontalAdvance(QStringLiteral("0.00!")), -metrics.height() / 2.0);
    const double scale = std::max(1.0, std::min(inner.width() / box.width(), inner.height() / box.height()));
    return {inner.center() - scale * box.center(), scale};
}

void SonarRingView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (ring_.cones.empty())
        return paintEmptySheet(painter, *this, tr("The places of the sonars are not known yet."));
    paintSheet(painter, *this);
    paintHead(painter, tr("sonar, from above, m"));
    const QRectF room = QRectF(rect()).adjusted(gap::tiny, sheetHead_px(*this), -gap::tiny, -gap::tiny);
    const Frame frame = frameFor(room);
    paintArcs(painter, frame, room);
    for (const SonarCone& cone : ring_.cones)
        paintCone(painter, frame, cone);
    paintRobot(painter, frame);
    for (const SonarCone& cone : ring_.cones)
        paintRange(painter, frame, cone);
}

void SonarRingView::paintArcs(QPainter& painter, const Frame& frame, const QRectF& room) const {
    double farthest_m = 0.0;
    for (const SonarCone& cone : ring_.cones)
        farthest_m = std::max(farthest_m, cone.maximum_m);
    const double step_m = roundStep(farthest_m / 2.0);
    painter.save();
    painter.setClipRect(room);
    for (double arc_m = step_m; arc_m < farthest_m + 0.5 * step_m; arc_m += step_m) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tokens().line, 1.0, Qt::DotLine));
        painter.drawEllipse(frame.origin, arc_m * frame.scale, arc_m * frame.scale);
    }
    painter.restore();
    const double y = room.bottom() - 3.0;
    painter.setPen(QPen(tokens().text_muted, 1.5));
    painter.drawLine(QPointF(gap::small, y), QPointF(gap::small + step_m * frame.scale, y));
    paintSheetNote(painter, QPointF(gap::small + step_m * frame.scale + gap::tiny, y + 2.0), tr("%1 m").arg(step_m));
}

void SonarRingView::paintCone(QPainter& painter, const Frame& frame, const SonarCone& cone) const {
    painter.setPen(QPen(faded(ink(tokens().text_muted), 0.6), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(sector(frame, cone, cone.maximum_m));
    if (!std::isfinite(cone.range_m))
        return;
    const bool free = cone.range_m >= cone.maximum_m;
    const QColor fill = ink(riskColor(cone.risk));
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(fill, stale() ? 0.25 : free ? 0.18 : 0.45));
    const QPolygonF reach = sector(frame, cone, std::clamp(cone.range_m, 0.0, cone.maximum_m));
    painter.drawPolygon(reach);
    if (free)
        return;
    painter.setPen(QPen(fill, 2.5)); // The echo.
    painter.drawPolyline(reach.sliced(1));
}

void SonarRingView::paintRange(QPainter& painter, const Frame& frame, const SonarCone& cone) const {
    const bool risky = cone.risk != agent::Risk::None && !stale();
    QFont font = themeFont(FontRole::Small, risky ? QFont::Bold : QFont::Normal);
    font.setStrikeOut(stale());
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const QString text = figure(cone.range_m, 2) + (risky ? QStringLiteral("!") : QString());
    const QSizeF size(metrics.horizontalAdvance(text) + 2.0, metrics.height());
    const Vec2 direction = toward(cone.bearing_rad);
    const QPointF rim = frame(cone.at_m + cone.maximum_m * direction);
    // The nearest edge of the words touches the rim, whatever the direction.
    const QPointF outward(-direction.y() * size.width() / 2.0, -direction.x() * size.height() / 2.0);
    painter.setPen(risky ? riskColor(cone.risk) : ink(tokens().text));
    painter.drawText(QRectF(rim + outward - QPointF(size.width() / 2.0, size.height() / 2.0), size), Qt::AlignCenter,
                     text);
}

void SonarRingView::paintRobot(QPainter& painter, const Frame& frame) const {
    const QColor body = ink(tokens().text);
    const double width = std::max(6.0, ring_.width_m * frame.scale);
    const double length = std::max(6.0, ring_.length_m * frame.scale);
    const QRectF outline(frame.origin - QPointF(width / 2.0, length / 2.0), QSizeF(width, length));
    painter.setPen(QPen(body, 1.5));
    painter.setBrush(tokens().raised);
    painter.drawRoundedRect(outline, 2.0, 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(body); // A tip that says where ahead is.
    const double tip = std::clamp(width * 0.3, 2.5, 6.0);
    const QPointF nose(outline.center().x(), outline.top() + 2.0);
    painter.drawPolygon(QPolygonF{nose, nose + QPointF(-tip, 1.4 * tip), nose + QPointF(tip, 1.4 * tip)});
}

} // namespace usar::widgets
