#include "widgets/laser_fan_view.h"

#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/models/map_transform.h"
#include "widgets/sheet.h"
#include "widgets/theme.h"

namespace usar::widgets {

LaserFanView::LaserFanView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Laser scan"));
    setToolTip(
        tr("Rays of the range scanner across the robot, seen from behind, and the terrain line under it. Metres."));
}

void LaserFanView::setScan(const protocol::RangeScan& scan, double maximum_m) {
    section_ = laserSection(scan, maximum_m);
    stale_ = false;
    setAccessibleDescription(section_.clearance_m ? tr("%1 m above ground").arg(figure(*section_.clearance_m, 2))
                                                  : tr("No ground in range"));
    update();
}

void LaserFanView::clear() {
    section_ = {};
    setAccessibleDescription(tr("No scan yet"));
    update();
}

void LaserFanView::setStale(bool stale) {
    if (stale == stale_)
        return;
    stale_ = stale;
    update();
}

void LaserFanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (section_.rays.empty())
        return paintEmptySheet(painter, *this,
                               tr("No laser scan yet.\nRays and terrain appear here once a range scanner reports."));
    paintSheet(painter, *this);
    const double head = fontMetrics().height() + 12.0;
    const double scale = (height() - head - gap::small) / section_.depthShown_m();
    const QPointF origin(width() / 2.0, head);
    painter.setClipRect(rect().adjusted(1, 1, -1, -1));
    std::vector<std::optional<QPointF>> ground;
    for (const LaserRay& ray : section_.rays)
        ground.push_back(ray.hit ? std::optional(origin + ray.end_m * scale) : std::nullopt);
    paintGround(painter, ground, height(), stale_);
    paintRays(painter, origin, scale);
    const QColor body = stale_ ? tokens().stale : tokens().text;
    painter.setPen(QPen(body, 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin + QPointF(-9.0, 0.0), origin + QPointF(9.0, 0.0));
    painter.setBrush(body);
    painter.drawEllipse(origin, 3.5, 3.5);
    paintWords(painter, scale);
}

void LaserFanView::paintRays(QPainter& painter, const QPointF& origin, double scale) const {
    QColor ink = stale_ ? tokens().stale : tokens().laser;
    ink.setAlphaF(0.30f);
    QVector<QLineF> rays;
    for (const LaserRay& ray : section_.rays)
        if (ray.hit)
            rays << QLineF(origin, origin + ray.end_m * scale);
    painter.setPen(QPen(ink, 1.0));
    painter.drawLines(rays);
}

void LaserFanView::paintWords(QPainter& painter, double scale) const {
    paintSheetHead(painter, *this, tr("laser"),
                   tr("%1 m to ground").arg(figure(section_.clearance_m.value_or(qQNaN()), 2, 5)), stale_);
    const double bar_m = roundStep(80.0 / scale);
    const double y = height() - 7.0;
    painter.setPen(QPen(tokens().text_muted, 1.5));
    painter.drawLine(QPointF(gap::small, y), QPointF(gap::small + bar_m * scale, y));
    paintSheetNote(painter, QPointF(gap::small + bar_m * scale + gap::tiny, y + 4.0),
                   QStringLiteral("%1 m").arg(bar_m));
}

} // namespace usar::widgets
