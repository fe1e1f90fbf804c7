#include "widgets/panels/laser_fan_view.h"

#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

LaserFanView::LaserFanView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Laser scan"));
    setToolTip(
        tr("Rays of the range scanner, in meters. For a flying robot they are seen from behind, with the terrain line "
           "below it; for any other robot from above, with what is ahead at the top."));
}

void LaserFanView::setScan(const protocol::RangeScan& scan, double maximum_m, ScanPlane plane) {
    section_ = laserSection(scan, maximum_m);
    plane_ = plane;
    showFresh(section_.clearance_m        ? clearanceText(0)
              : plane == ScanPlane::Below ? tr("No ground in range")
                                          : tr("Nothing ahead in range"));
}

QString LaserFanView::clearanceText(int digits) const {
    const QString distance = figure(section_.clearance_m.value_or(qQNaN()), 2, digits);
    return plane_ == ScanPlane::Below ? tr("%1 m to ground").arg(distance) : tr("%1 m ahead").arg(distance);
}

void LaserFanView::clear() {
    section_ = {};
    setAccessibleDescription(tr("No scan yet"));
    update();
}

void LaserFanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (section_.rays.empty())
        return paintEmptySheet(painter, *this,
                               tr("No laser scan yet.\nRays and terrain appear here once a range scanner reports."));
    paintSheet(painter, *this);
    const double head = fontMetrics().height() + 12.0;
    const double room = height() - head - gap::small;
    const double scale = room / section_.depthShown_m();
    const QPointF origin(width() / 2.0, plane_ == ScanPlane::Below ? head : head + room);
    painter.setClipRect(rect().adjusted(1, 1, -1, -1));
    paintSurface(painter, origin, scale);
    paintRays(painter, origin, scale);
    paintRobot(painter, origin);
    paintWords(painter, scale);
}

QPointF LaserFanView::onScreen(const LaserRay& ray, const QPointF& origin, double scale) const {
    const double up = plane_ == ScanPlane::Below ? 1.0 : -1.0;
    return origin + QPointF(ray.end_m.x(), up * ray.end_m.y()) * scale;
}

void LaserFanView::paintSurface(QPainter& painter, const QPointF& origin, double scale) const {
    std::vector<std::optional<QPointF>> surface;
    for (const LaserRay& ray : section_.rays)
        surface.push_back(ray.hit ? std::optional(onScreen(ray, origin, scale)) : std::nullopt);
    if (plane_ == ScanPlane::Below)
        return paintGround(painter, surface, height(), stale());
    painter.setPen(Qt::NoPen); // Walls and posts do not form a line.
    painter.setBrush(ink(tokens().ok));
    for (const std::optional<QPointF>& hit : surface)
        if (hit)
            painter.drawEllipse(*hit, 1.5, 1.5);
}

void LaserFanView::paintRobot(QPainter& painter, const QPointF& origin) const {
    const QColor body = ink(tokens().text);
    painter.setPen(QPen(body, 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin + QPointF(-9.0, 0.0), origin + QPointF(9.0, 0.0));
    painter.setBrush(body);
    painter.drawEllipse(origin, 3.5, 3.5);
}

void LaserFanView::paintRays(QPainter& painter, const QPointF& origin, double scale) const {
    QVector<QLineF> rays;
    for (const LaserRay& ray : section_.rays)
        if (ray.hit)
            rays << QLineF(origin, onScreen(ray, origin, scale));
    painter.setPen(QPen(faded(ink(tokens().laser), 0.30), 1.0));
    painter.drawLines(rays);
}

void LaserFanView::paintWords(QPainter& painter, double scale) const {
    paintSheetHead(painter, *this, tr("laser"), clearanceText(5), stale());
    const double bar_m = roundStep(80.0 / scale);
    const double y = height() - 7.0;
    painter.setPen(QPen(tokens().text_muted, 1.5));
    painter.drawLine(QPointF(gap::small, y), QPointF(gap::small + bar_m * scale, y));
    paintSheetNote(painter, QPointF(gap::small + bar_m * scale + gap::tiny, y + 4.0),
                   QStringLiteral("%1 m").arg(bar_m));
}

} // namespace usar::widgets
