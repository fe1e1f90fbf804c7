#include "widgets/panels/instruments.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

QString heightText(double height_m) {
    return TerrainProfileView::tr("%1 m").arg(figure(height_m, 0));
}

} // namespace

LaserFanView::LaserFanView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Laser scan"));
    setToolTip(
        tr("Rays of the range scanner, in meters. For a flying robot they are seen from behind, with the terrain line "
           "below it; for any other robot from above, with what is ahead at the top."));
}

void LaserFanView::setScan(const protocol::RangeScan& scan, double maximum_m, ScanPlane plane) {
    section_ = laserSection(scan, maximum_m);
    plane_ = plane;
    showFresh(section_.rays.empty()       ? tr("No scan yet")
              : section_.clearance_m      ? clearanceText(0)
              : plane == ScanPlane::Below ? tr("No ground in range")
                                          : tr("Nothing ahead in range"));
}

QString LaserFanView::clearanceText(int digits) const {
    const QString distance = figure(section_.clearance_m.value_or(qQNaN()), 2, digits);
    return plane_ == ScanPlane::Below ? tr("%1 m to ground").arg(distance) : tr("%1 m ahead").arg(distance);
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
    paintHead(painter, tr("laser"), clearanceText(5));
    const double bar_m = roundStep(80.0 / scale);
    const double y = height() - 7.0;
    painter.setPen(QPen(tokens().text_muted, 1.5));
    painter.drawLine(QPointF(gap::small, y), QPointF(gap::small + bar_m * scale, y));
    paintSheetNote(painter, QPointF(gap::small + bar_m * scale + gap::tiny, y + 4.0),
                   QStringLiteral("%1 m").arg(bar_m));
}

TerrainProfileView::TerrainProfileView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Terrain profile"));
    setToolTip(tr("Mapped heights along the robot's course: behind it on the left, ahead on the right. In "
                  "meters; heights are stretched."));
}

void TerrainProfileView::setProfile(const mapping::CourseProfile& profile) {
    profile_ = profile;
    showFresh(profile_.points.empty() ? tr("No map yet") : clearanceText());
}

QString TerrainProfileView::clearanceText() const {
    const std::optional<double> ground_m = profile_.groundBelow_m();
    return ground_m ? tr("%1 m above the map").arg(figure(profile_.robot_z_m - *ground_m, 1, 4)) : tr("unmapped here");
}

TerrainProfileView::Span TerrainProfileView::span() const {
    double low_m = profile_.robot_z_m;
    double high_m = profile_.robot_z_m;
    for (const mapping::ProfilePoint& point : profile_.points)
        if (point.height_m) {
            low_m = std::min(low_m, double(*point.height_m));
            high_m = std::max(high_m, double(*point.height_m));
        }
    const double step_m = roundStep(std::max(4.0, high_m - low_m) / 2.0);
    return {step_m * std::floor((low_m - 0.1 * step_m) / step_m), step_m * std::ceil((high_m + 0.1 * step_m) / step_m)};
}

QPointF TerrainProfileView::place(double distance_m, double height_m, const QRectF& plot, const Span& span) const {
    return {plot.center().x() + distance_m / profile_.reach_m * plot.width() / 2.0,
            plot.bottom() - (height_m - span.low_m) / (span.high_m - span.low_m) * plot.height()};
}

void TerrainProfileView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (profile_.points.empty())
        return paintEmptySheet(painter, *this, tr("No terrain profile yet.\nIt appears here as the map grows."));
    paintSheet(painter, *this);
    paintHead(painter, tr("mapped terrain"), clearanceText());
    const Span heights = span();
    const QRectF plot =
        QRectF(rect()).adjusted(gap::small + scaleWidth_px(heights), sheetHead_px(*this), -gap::small, -gap::small);
    std::vector<std::optional<QPointF>> ground(profile_.points.size());
    std::ranges::transform(profile_.points, ground.begin(), [&](const mapping::ProfilePoint& point) {
        return point.height_m ? std::optional(place(point.distance_m, *point.height_m, plot, heights)) : std::nullopt;
    });
    paintGround(painter, ground, plot.bottom(), stale());
    paintScale(painter, plot, heights);
    paintRobot(painter, plot, heights);
}

void TerrainProfileView::paintRobot(QPainter& painter, const QRectF& plot, const Span& span) const {
    const QColor body = ink(tokens().text);
    const QPointF robot = place(0.0, profile_.robot_z_m, plot, span);
    if (const std::optional<double> ground_m = profile_.groundBelow_m()) {
        painter.setPen(QPen(body, 1.0, Qt::DotLine));
        painter.drawLine(robot, place(0.0, *ground_m, plot, span));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(body);
    painter.drawPolygon(QPolygonF{robot + QPointF(8.0, 0.0), robot + QPointF(-6.0, -4.5), robot + QPointF(-6.0, 4.5)});
}

double TerrainProfileView::scaleWidth_px(const Span& span) {
    const QFontMetricsF metrics(themeFont(FontRole::Small));
    return gap::tiny + std::max(metrics.horizontalAdvance(heightText(span.low_m)),
                                metrics.horizontalAdvance(heightText(span.high_m)));
}

void TerrainProfileView::paintScale(QPainter& painter, const QRectF& plot, const Span& span) const {
    const QFontMetricsF metrics(themeFont(FontRole::Small));
    const QString reach = tr("%1 m ahead").arg(figure(profile_.reach_m, 0));
    paintSheetNote(painter, QPointF(plot.right() - metrics.horizontalAdvance(reach), plot.bottom()), reach);
    const QRectF scale(gap::small, plot.top(), plot.left() - gap::small - gap::tiny, plot.height());
    painter.drawText(scale, Qt::AlignRight | Qt::AlignTop, heightText(span.high_m));
    painter.drawText(scale, Qt::AlignRight | Qt::AlignBottom, heightText(span.low_m));
}

SonarColumnsView::SonarColumnsView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Sonars"));
    setToolTip(tr("Range of each sonar in meters, from left to right as they are mounted on the robot. "
                  "Bands: high risk (dense) and low risk (light)."));
}

void SonarColumnsView::setZones(const agent::SonarZones& zones) {
    if (zones.zones == columns_ && !columns_.empty())
        return;
    columns_ = zones.zones;
    const auto risky = std::ranges::count_if(columns_, [](const auto& c) { return c.risk != agent::Risk::None; });
    showFresh(columns_.empty() ? tr("No sonars yet") : tr("%1 sonars, %2 at risk").arg(columns_.size()).arg(risky));
}

void SonarColumnsView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (columns_.empty())
        return paintEmptySheet(painter, *this, tr("No sonars yet.\nOne column each appears here once they report."));
    paintSheet(painter, *this);
    paintHead(painter, tr("sonar, m"));
    const double top = sheetHead_px(*this);
    const double step = (width() - 2.0 * gap::tiny) / static_cast<double>(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i)
        paintColumn(painter, columns_[i],
                    QRectF(gap::tiny + static_cast<double>(i) * step, top, step, height() - top - 2.0));
}

void SonarColumnsView::paintColumn(QPainter& painter, const agent::SonarZone& column, const QRectF& cell) const {
    const Tokens& t = tokens();
    painter.setFont(themeFont(FontRole::Small));
    const double line = QFontMetricsF(painter.font()).height();
    const bool risky = column.risk != agent::Risk::None && !stale();
    const QRectF shaft = cell.adjusted(3.0, line + 2.0, -3.0, -2.0 * line - 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.raised);
    painter.drawRect(shaft);
    paintZones(painter, column, shaft);
    const double part = std::clamp(column.range_m / column.maximum_m, 0.0, 1.0);
    if (std::isfinite(column.range_m)) {
        const double bar = shaft.height() * part;
        painter.setBrush(faded(ink(riskColor(column.risk)), stale() ? 0.4 : 0.85));
        painter.setPen(Qt::NoPen);
        painter.drawRect(shaft.adjusted(shaft.width() * 0.22, shaft.height() - bar, -shaft.width() * 0.22, 0.0));
    }
    QFont font = painter.font();
    font.setStrikeOut(stale());
    painter.setFont(font);
    painter.setPen(ink(t.text));
    painter.drawText(QRectF(cell.left() - 4.0, cell.top(), cell.width() + 8.0, line), Qt::AlignCenter,
                     figure(column.range_m, column.range_m >= 10.0 ? 1 : 2));
    font.setStrikeOut(false);
    font.setBold(risky);
    painter.setFont(font);
    painter.setPen(risky ? riskColor(column.risk) : t.text_muted);
    painter.drawText(QRectF(cell.left() - 4.0, shaft.bottom() + 1.0, cell.width() + 8.0, line), Qt::AlignCenter,
                     QString::fromStdString(column.name));
    if (risky)
        painter.drawText(QRectF(cell.left() - 4.0, shaft.bottom() + 1.0 + line, cell.width() + 8.0, line),
                         Qt::AlignCenter, riskWord(column.risk));
}

void SonarColumnsView::paintZones(QPainter& painter, const agent::SonarZone& column, const QRectF& shaft) const {
    const auto level = [&](double range_m) {
        return shaft.bottom() - shaft.height() * std::clamp(range_m / column.maximum_m, 0.0, 1.0);
    };
    if (!(column.low_risk_below_m > 0.0))
        return;
    const double high = level(column.high_risk_below_m);
    const double low = level(column.low_risk_below_m);
    const QColor danger = ink(riskColor(agent::Risk::High));
    const QColor caution = ink(riskColor(agent::Risk::Low));
    painter.fillRect(QRectF(QPointF(shaft.left(), high), shaft.bottomRight()), faded(danger, 0.22));
    painter.fillRect(QRectF(QPointF(shaft.left(), low), QPointF(shaft.right(), high)), faded(caution, 0.40));
    painter.setPen(QPen(danger, 1.0));
    painter.drawLine(QPointF(shaft.left(), high), QPointF(shaft.right(), high));
    painter.setPen(QPen(caution, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(shaft.left(), low), QPointF(shaft.right(), low));
}

} // namespace usar::widgets
