#include "widgets/panels/terrain_profile_view.h"

#include <algorithm>
#include <cmath>

#include "widgets/models/figures.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {
QString heightText(double height_m) {
    return TerrainProfileView::tr("%1 m").arg(figure(height_m, 0));
}
} // namespace

TerrainProfileView::TerrainProfileView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Terrain profile"));
    setToolTip(tr("Mapped heights along the robot's course: behind it on the left, ahead on the right. In "
                  "meters; heights are stretched."));
}

void TerrainProfileView::setProfile(const mapping::CourseProfile& profile) {
    profile_ = profile;
    showFresh(clearanceText());
}

void TerrainProfileView::clear() {
    profile_ = {};
    setAccessibleDescription(tr("No map yet"));
    update();
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
    paintSheetHead(painter, *this, tr("mapped terrain"), clearanceText(), stale());
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

} // namespace usar::widgets
